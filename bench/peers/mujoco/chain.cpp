/* MuJoCo as a contender for F: bodies hung in each other by hinges about y, point masses (MuJoCo wants some inertia: tiny_inertia),
 * everything off that a chain does not need. MuJoCo has no derivatives of its accelerations but finite differences, so no J and no V.
 *   (default)  mj_forward, which also computes frames of inertia, bounds of the bodies' subtrees and all stages that are switched off
 *   -DSTAGES   of mj_forward only the stages that the accelerations need, called one by one */
#include "contender.h"
#include "relative_angles.h"

#include <mujoco/mujoco.h>

#include <cstring>
#include <sstream>

namespace {

const double tiny_inertia = 1e-14; /* kg m^2; MuJoCo refuses less than 1e-15 */

struct chain {
  int n;
  bool absolute; /* the model's angles are absolute */
  mjModel *model;
  mjData *data;
};

std::string describe(const bench_case &problem) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<mujoco><compiler angle='radian'/><option gravity='0 0 " << -problem.gravity << "'/><worldbody>";
  for (int i = 0; i < problem.n; i++)
    xml << "<body pos='0 0 " << (i ? -problem.length[i - 1] : 0.0) << "'><joint type='hinge' axis='0 1 0'/><inertial pos='0 0 "
        << -problem.length[i] << "' mass='" << problem.mass[i] << "' diaginertia='" << tiny_inertia << ' ' << tiny_inertia << ' '
        << tiny_inertia << "'/>";
  for (int i = 0; i < problem.n; i++) xml << "</body>";
  xml << "</worldbody></mujoco>";
  return xml.str();
}

void solve(const mjModel *m, mjData *d, double *qdd) {
#ifdef STAGES
  mj_kinematics(m, d);
  mj_comPos(m, d);
  mj_makeM(m, d);
  mj_factorM(m, d);
  mj_comVel(m, d);
  mj_rne(m, d, 0, d->qfrc_bias);
  for (int i = 0; i < m->nv; i++) d->qfrc_smooth[i] = -d->qfrc_bias[i];
  mj_solveM(m, d, qdd, d->qfrc_smooth, 1);
#else
  mj_forward(m, d);
  std::memcpy(qdd, d->qacc, static_cast<size_t>(m->nv) * sizeof(double));
#endif
}

int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  chain &c = *static_cast<chain *>(self);
  std::memcpy(c.data->qpos, q, static_cast<size_t>(c.n) * sizeof(double));
  std::memcpy(c.data->qvel, qd, static_cast<size_t>(c.n) * sizeof(double));
  solve(c.model, c.data, qdd);
  return 0;
}

void to_native(void *self, const double *q, const double *qd, const double *w, double *native_q, double *native_qd, double *native_w) {
  const chain &c = *static_cast<chain *>(self);
  relative_state(c.n, c.absolute, q, qd, w, native_q, native_qd, native_w);
}

void from_native(void *self, char need, const double *, const double *, double *qdd, double *qdd_y, double *dqdd) {
  const chain &c = *static_cast<chain *>(self);
  model_results(c.n, c.absolute, need, qdd, qdd_y, dqdd);
}

} // namespace

extern "C" int bench_open(const bench_case *problem, bench_contender *contender) {
  mjSpec *spec = mj_parseXMLString(describe(*problem).c_str(), nullptr, nullptr, 0);
  if (!spec) return 1;
  mjModel *model = mj_compile(spec, nullptr);
  mj_deleteSpec(spec);
  if (!model) return 1;
  model->opt.disableflags = mjDSBL_CONSTRAINT | mjDSBL_CONTACT | mjDSBL_SPRING | mjDSBL_DAMPER | mjDSBL_ACTUATION | mjDSBL_SENSOR |
                            mjDSBL_WARMSTART | mjDSBL_ISLAND | mjDSBL_MIDPHASE;
  chain *c = new chain{problem->n, has_absolute_angles(*problem), model, mj_makeData(model)};
  *contender = {c, 1, acceleration, nullptr, nullptr, to_native, from_native};
  return 0;
}
