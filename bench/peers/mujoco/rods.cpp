/* MuJoCo as a contender for the chain in Cartesian coordinates: masses on two sliders each, rods as spatial tendons whose length an
 * equality fixes. Its constraints are soft by design and leave out dA/dt qd, so that the accelerations are not those of the rods; the
 * default stiffness with the least softness that its manual allows is used. F: mj_forward. */
#include "rods.h"
#include "contender.h"

#include <mujoco/mujoco.h>

#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct chain {
  int n;
  std::vector<double> length;
  mjModel *model;
  mjData *data;
};

std::string describe(const bench_case &problem) {
  std::ostringstream xml;
  xml.precision(17);
  xml << "<mujoco><option gravity='0 0 " << -problem.gravity << "'/><worldbody><site name='s0'/>";
  for (int i = 0; i < problem.n; i++)
    xml << "<body><joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 0 1'/><inertial pos='0 0 0' mass='" << problem.mass[i]
        << "' diaginertia='1e-6 1e-6 1e-6'/><site name='s" << i + 1 << "'/></body>";
  xml << "</worldbody><tendon>";
  for (int i = 0; i < problem.n; i++)
    xml << "<spatial name='rod" << i << "'><site site='s" << i << "'/><site site='s" << i + 1 << "'/></spatial>";
  xml << "</tendon><equality>";
  for (int i = 0; i < problem.n; i++)
    xml << "<tendon tendon1='rod" << i << "' polycoef='" << problem.length[i] << " 0 0 0 0' solimp='0.9999 0.9999 0.001 0.5 2'/>";
  xml << "</equality></mujoco>";
  return xml.str();
}

int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  chain &c = *static_cast<chain *>(self);
  const size_t bytes = static_cast<size_t>(c.model->nv) * sizeof(double);
  std::memcpy(c.data->qpos, q, bytes);
  std::memcpy(c.data->qvel, qd, bytes);
  mj_forward(c.model, c.data);
  std::memcpy(qdd, c.data->qacc, bytes);
  return 0;
}

} // namespace

extern "C" int bench_open(const bench_case *problem, bench_contender *contender) {
  mjSpec *spec = mj_parseXMLString(describe(*problem).c_str(), nullptr, nullptr, 0);
  mjModel *model = spec ? mj_compile(spec, nullptr) : nullptr;
  if (spec) mj_deleteSpec(spec);
  if (!model) return 1;
  model->opt.disableflags = mjDSBL_CONTACT | mjDSBL_SPRING | mjDSBL_DAMPER | mjDSBL_ACTUATION | mjDSBL_SENSOR | mjDSBL_WARMSTART |
                            mjDSBL_ISLAND | mjDSBL_MIDPHASE;
  chain *c = new chain{problem->n, {problem->length, problem->length + problem->n}, model, mj_makeData(model)};
  *contender = {c, 1, acceleration, nullptr, nullptr, to_rods<chain>, from_rods<chain>, 2 * problem->n, 1};
  return 0;
}
