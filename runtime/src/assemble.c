/* Assembly of M, Q, A, b and the energy: by motion functions, or from jets of the model's functions. */
#include "eom/assemble.h"

#include "baumgarte.h"
#include "evaluate.h"
#include "stage.h"

#include <assert.h>
#include <string.h>

/* ---- energy ---- */

/* sum -= [t_u] D. */
static eom_status add_dissipation(eom_system *sys, tl_real *sum, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_workspace *ws = sys->workspace;
  eom_stage_seed(sys, STAGE_DISSIPATION, q, qd, NULL, t);
  if (eom_stage_run(sys, &sys->model->dissipation) != EOM_OK) return sys->report.status;
  const tl_real *row = ws->jet_out + ws->stage[STAGE_DISSIPATION].shape->start[1];
  for (int i = 0; i < sys->n; i++) sum[i] -= row[i];
  return EOM_OK;
}

/* sum += Gamma - [t_u] D. */
static eom_status add_forces(eom_system *sys, tl_real *sum, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_workspace *ws = sys->workspace;
  if (sys->model->force.jet) {
    eom_stage_seed(sys, STAGE_GAMMA, q, qd, NULL, t);
    if (eom_stage_run(sys, &sys->model->force) != EOM_OK) return sys->report.status;
    for (int i = 0; i < sys->n; i++) sum[i] += ws->jet_out[i];
  }
  if (sys->model->dissipation.jet && add_dissipation(sys, sum, q, qd, t) != EOM_OK) return sys->report.status;
  return eom_check_finite(sys, "generalized force", sum, sys->n);
}

/* E = p.qd - L, where L is value and p stands in by_qd. */
static void read_energy(eom_system *sys, tl_real value, const tl_real *by_qd, const tl_real *qd) {
  memcpy(sys->momentum, by_qd, (size_t)sys->n * sizeof(tl_real));
  sys->lagrangian = value;
  tl_real e = -value;
  for (int i = 0; i < sys->n; i++) e += sys->momentum[i] * qd[i];
  sys->energy = e;
}

/* By the first derivatives of L. */
static eom_status energy_by_calls(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  eom_workspace *ws = sys->workspace;
  const int n = sys->n;
  eom_stage_seed(sys, STAGE_ENERGY, q, qd, NULL, t);
  if (eom_stage_run(sys, &sys->model->lagrangian) != EOM_OK) return sys->report.status;
  const tl_real *row = ws->jet_out + ws->stage[STAGE_ENERGY].shape->start[1];
  memcpy(sys->momentum_rate, row, (size_t)n * sizeof(tl_real));
  read_energy(sys, ws->jet_out[0], row + n, qd);
  if (eom_check_finite(sys, "energy", &sys->energy, 1) != EOM_OK) return sys->report.status;
  return add_forces(sys, sys->momentum_rate, q, qd, t);
}

static eom_status energy_by_motion(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const int code = sys->motion->energy(sys->params, q, qd, t, sys->momentum, sys->momentum_rate, &sys->lagrangian, &sys->energy,
                                       sys->workspace->motion_work);
  return eom_motion_verdict(sys, code, q, qd, t);
}

static eom_status energy(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  return eom_by_motion(sys, EOM_TASK_ENERGY) ? energy_by_motion(sys, q, qd, t) : energy_by_calls(sys, q, qd, t);
}

eom_status eom_energy(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  return eom_start(sys, q, qd, t) == EOM_OK ? energy(sys, q, qd, t) : sys->report.status;
}

/* ---- parts of the equations from jets ---- */

/* M_ij = d2L/du_i du_j: the packed upper triangle of order 2, where coefficient = derivative off the diagonal and half of it on it. */
static void read_mass(eom_system *sys, const tl_real *jet, const tl_shape *shape) {
  const int n = sys->n;
  const tl_real *packed = jet + shape->start[2];
  for (int i = 0; i < n; i++) {
    sys->M[i * n + i] = TL_C(2.0) * *packed++;
    for (int j = i + 1; j < n; j++) sys->M[i * n + j] = sys->M[j * n + i] = *packed++;
  }
}

static eom_status assemble_mass(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  eom_workspace *ws = sys->workspace;
  eom_stage_seed(sys, STAGE_MASS, q, qd, NULL, t);
  if (eom_stage_run(sys, &sys->model->lagrangian) != EOM_OK) return sys->report.status;
  read_mass(sys, ws->jet_out, ws->stage[STAGE_MASS].shape);
  read_energy(sys, ws->jet_out[0], ws->jet_out + ws->stage[STAGE_MASS].shape->start[1], qd);
  if (eom_check_finite(sys, "energy", &sys->energy, 1) != EOM_OK) return sys->report.status;
  return eom_check_finite(sys, "mass matrix", sys->M, sys->n * sys->n);
}

/* Q - M qdd = [t_x] L + Gamma - [t_u] D - [s t_u] L along q + s qd + s^2/2 qdd, qd + s qdd, t + s. sum: n; qdd null: zero. What stands
 * before the last term is the momentum's rate. */
static eom_status unbalanced_force(eom_system *sys, tl_real *sum, const tl_real *q, const tl_real *qd, const tl_real *qdd, tl_real t) {
  eom_workspace *ws = sys->workspace;
  const int n = sys->n;
  eom_stage_seed(sys, STAGE_FORCE, q, qd, qdd, t);
  if (eom_stage_run(sys, &sys->model->lagrangian) != EOM_OK) return sys->report.status;
  const tl_real *row = ws->jet_out + ws->stage[STAGE_FORCE].shape->start[1], *row_s = row + 2 * n;
  memcpy(sys->momentum_rate, row, (size_t)n * sizeof(tl_real));
  for (int i = 0; i < n; i++) sum[i] = -row_s[n + i];
  if (add_forces(sys, sys->momentum_rate, q, qd, t) != EOM_OK) return sys->report.status;
  for (int i = 0; i < n; i++) sum[i] += sys->momentum_rate[i];
  return eom_check_finite(sys, "generalized force", sum, n);
}

/* Row r of A is [t_x] phi_r; phi'' = A qdd - b is 2[s2] phi_r, so b_r = -2[s2] phi_r at qdd = 0. The terms that cancel in b are of the
 * size of |dA/dt| |qd| = sum_k |[s t_xk] phi_r| |qd_k|. */
static void read_holonomic(eom_system *sys, const tl_real *jet, const tl_shape *shape, const tl_real *qd, int r) {
  const int n = sys->n;
  const tl_real *row = jet + shape->start[1], *row_s = row + n;
  memcpy(sys->A + r * n, row, (size_t)n * sizeof(tl_real));
  sys->phi[r] = jet[0];
  sys->phi_dot[r] = jet[1];
  sys->b[r] = TL_C(-2.0) * jet[2];
  tl_real size = TL_LIBM(fabs)(sys->b[r]);
  for (int k = 0; k < n; k++) size += TL_LIBM(fabs)(row_s[k] * qd[k]);
  sys->workspace->b_size[r] = size;
}

static eom_status assemble_holonomic(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  eom_workspace *ws = sys->workspace;
  const tl_shape *shape = ws->stage[STAGE_HOLONOMIC].shape;
  eom_stage_seed(sys, STAGE_HOLONOMIC, q, qd, NULL, t);
  for (int f = 0, r = 0; f < sys->model->nholonomic; f++) {
    const eom_function *phi = &sys->model->holonomic[f];
    if (eom_stage_run(sys, phi) != EOM_OK) return sys->report.status;
    const int rows = phi->rows(sys->params);
    for (int i = 0; i < rows; i++) read_holonomic(sys, ws->jet_out + (size_t)i * (size_t)shape->ncoef, shape, qd, r++);
  }
  return eom_check_finite(sys, "phi", sys->phi, sys->m1);
}

/* Row r of A is [t_u] psi_r; psi' = A qdd - b is [s] psi_r, so b_r = -[s] psi_r at qdd = 0. */
static void read_nonholonomic(eom_system *sys, const tl_real *jet, const tl_shape *shape, int r) {
  const int n = sys->n, row = sys->m1 + r;
  memcpy(sys->A + row * n, jet + shape->start[1], (size_t)n * sizeof(tl_real));
  sys->psi[r] = jet[0];
  sys->b[row] = -jet[1];
  sys->workspace->b_size[row] = TL_LIBM(fabs)(jet[1]);
}

static eom_status assemble_nonholonomic(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  eom_workspace *ws = sys->workspace;
  const tl_shape *shape = ws->stage[STAGE_NONHOLONOMIC].shape;
  eom_stage_seed(sys, STAGE_NONHOLONOMIC, q, qd, NULL, t);
  for (int f = 0, r = 0; f < sys->model->nnonholonomic; f++) {
    const eom_function *psi = &sys->model->nonholonomic[f];
    if (eom_stage_run(sys, psi) != EOM_OK) return sys->report.status;
    const int rows = psi->rows(sys->params);
    for (int i = 0; i < rows; i++) read_nonholonomic(sys, ws->jet_out + (size_t)i * (size_t)shape->ncoef, shape, r++);
  }
  return eom_check_finite(sys, "psi", sys->psi, sys->m2);
}

static eom_status assemble_by_calls(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  if (assemble_mass(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (unbalanced_force(sys, sys->Q, q, qd, NULL, t) != EOM_OK) return sys->report.status;
  if (sys->m1 > 0 && assemble_holonomic(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (sys->m2 > 0 && assemble_nonholonomic(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "constraint matrix", sys->A, sys->m * sys->n) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "constraint vector b", sys->b, sys->m) != EOM_OK) return sys->report.status;
  return EOM_OK;
}

/* ---- by either emitter ---- */

static eom_status assemble_by_motion(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_workspace *ws = sys->workspace;
  const eom_parts out = {sys->M, sys->Q, sys->phi, sys->phi_dot, sys->psi, sys->A, sys->b};
  const int code = sys->motion->simulate(sys->params, q, qd, t, &out, ws->motion_work);
  for (int r = 0; r < sys->m; r++) ws->b_size[r] = TL_C(0.0); /* at least |b|, says eom_solve */
  return eom_motion_verdict(sys, code, q, qd, t);
}

eom_status eom_assemble_parts(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const bool by_motion = eom_by_motion(sys, EOM_TASK_ASSEMBLE);
  const eom_status status = by_motion ? assemble_by_motion(sys, q, qd, t) : assemble_by_calls(sys, q, qd, t);
  if (status != EOM_OK) return status;
  eom_stabilise_holonomic(sys);
  eom_stabilise_nonholonomic(sys);
  return EOM_OK;
}

eom_status eom_size_rows(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_status status = sys->m1 > 0 ? assemble_holonomic(sys, q, qd, t) : EOM_OK;
  if (status == EOM_OK) eom_stabilise_holonomic(sys);
  return status;
}

eom_status eom_assemble(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  if (eom_start(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (eom_assemble_parts(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (!eom_by_motion(sys, EOM_TASK_ASSEMBLE)) return EOM_OK; /* calls leave energy and sizes on the way */
  return energy(sys, q, qd, t) == EOM_OK ? eom_size_rows(sys, q, qd, t) : sys->report.status;
}

/* ---- inverse dynamics ---- */

eom_status eom_residual(eom_system *sys, tl_real *r, const tl_real *qdd, const tl_real *q, const tl_real *qd, tl_real t) {
  assert(r && qdd);
  if (eom_start_needing(sys, EOM_NEED_RESIDUAL, q, qd, t) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "argument qdd", qdd, sys->n) != EOM_OK) return sys->report.status;
  if (eom_by_motion(sys, EOM_TASK_RESIDUAL)) {
    const int code = sys->motion->residual(sys->params, q, qd, t, qdd, r, sys->workspace->motion_work);
    return eom_motion_verdict(sys, code, q, qd, t);
  }
  const eom_status status = unbalanced_force(sys, r, q, qd, qdd, t);
  for (int i = 0; i < sys->n; i++) r[i] = -r[i];
  return status;
}
