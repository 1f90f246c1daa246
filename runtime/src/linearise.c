/* Exact linearisation of constrained motion, by motion functions or from jets.
 *
 * With r(q,qd,qdd,t) = d/dt dL/dqd - dL/dq + dD/dqd - Gamma = M qdd - Q the motion satisfies r = A' lambda and phi'' = 0, psi' = 0, so
 *   M dqdd - A' dlambda = -dr/dy dy + d(A' lambda)/dy dy,   A dqdd = -d(phi'', psi')/dy dy,
 * every derivative taken at the solved qdd and lambda. With x and u the tangents on q and qd (constant in s):
 *   dr_i/dx_j = [s u_i x_j] L - [x_i x_j] L + [u_i x_j] D - dGamma_i/dx_j
 *   dr_i/du_j = [s u_i u_j] L + [u_i x_j] L - [x_i u_j] L + [u_i u_j] D - dGamma_i/du_j
 *   dphi''/dx_j = 2 [s2 x_j] phi,  dphi''/du_j = 2 [s x_j] phi,  d(A'lambda)_i/dx_j = sum_r lambda_r [x_i x_j] phi_r
 *   dpsi'/dx_j = [s x_j] psi,  dpsi'/du_j = [s u_j] psi + [x_j] psi,  d(A'lambda)_i/dy_j = sum_r lambda_r [u_i y_j] psi_r
 * where brackets mean derivatives in the tangents and coefficients in s. */
#include "eom/linearise.h"

#include "baumgarte.h"
#include "evaluate.h"
#include "factor.h"
#include "stage.h"

#include <assert.h>
#include <string.h>

/* The block of second order in the tangents at one power of s. */
typedef struct second_order {
  const tl_real *packed;
  int nvar;
} second_order;

static second_order second_order_at(const tl_shape *s, const tl_real *jet, int k) {
  return (second_order){jet + s->start[2] + k * s->nhom[2], s->nvar};
}

/* The derivative with respect to t_i and t_j. */
static tl_real derivative(second_order h, int i, int j) {
  if (i == j) return TL_C(2.0) * h.packed[i * h.nvar - i * (i - 1) / 2];
  const int lo = i < j ? i : j, hi = i < j ? j : i;
  return h.packed[lo * h.nvar - lo * (lo - 1) / 2 + hi - lo];
}

/* rhs1 = -dr/dy, its part from L. */
static void read_lagrangian(eom_system *sys, const tl_shape *shape) {
  const eom_workspace *ws = sys->workspace;
  const int n = sys->n;
  const second_order h = second_order_at(shape, ws->jet_out, 0), h_s = second_order_at(shape, ws->jet_out, 1);
  for (int j = 0; j < n; j++) {
    tl_real *by_x = ws->rhs1 + j * n, *by_u = ws->rhs1 + (n + j) * n;
    for (int i = 0; i < n; i++) {
      by_x[i] = derivative(h, i, j) - derivative(h_s, n + i, j);
      by_u[i] = derivative(h, i, n + j) - derivative(h, n + i, j) - derivative(h_s, n + i, n + j);
    }
  }
}

/* rhs2 = -dpsi'/dy, rhs1 += d(A'lambda)/dy for one row. */
static void read_nonholonomic(eom_system *sys, const tl_shape *shape, const tl_real *jet, int row) {
  const eom_workspace *ws = sys->workspace;
  const int n = sys->n, m = sys->m;
  const tl_real *first = jet + shape->start[1], *first_s = first + 2 * n;
  const second_order h = second_order_at(shape, jet, 0);
  for (int j = 0; j < n; j++) {
    ws->rhs2[j * m + row] = -first_s[j];
    ws->rhs2[(n + j) * m + row] = -first_s[n + j] - first[j];
  }
  for (int j = 0; j < 2 * n; j++)
    for (int i = 0; i < n; i++) ws->rhs1[j * n + i] += sys->lambda[row] * derivative(h, n + i, j);
}

static eom_status linearise_motion(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_workspace *ws = sys->workspace;
  const tl_shape *shape = ws->stage[STAGE_LINEARISE].shape;
  eom_stage_seed(sys, STAGE_LINEARISE, q, qd, sys->qdd, t);
  if (eom_stage_run(sys, &sys->model->lagrangian) != EOM_OK) return sys->report.status;
  read_lagrangian(sys, shape);
  for (int f = 0, r = sys->m1; f < sys->model->nnonholonomic; f++) {
    const eom_function *psi = &sys->model->nonholonomic[f];
    if (eom_stage_run(sys, psi) != EOM_OK) return sys->report.status;
    const int rows = psi->rows(sys->params);
    for (int i = 0; i < rows; i++) read_nonholonomic(sys, shape, ws->jet_out + (size_t)i * (size_t)shape->ncoef, r++);
  }
  return EOM_OK;
}

/* rhs1 += dGamma/dy. */
static eom_status linearise_force(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_workspace *ws = sys->workspace;
  const tl_shape *shape = ws->stage[STAGE_GAMMA_LINEARISE].shape;
  const int n = sys->n;
  eom_stage_seed(sys, STAGE_GAMMA_LINEARISE, q, qd, NULL, t);
  if (eom_stage_run(sys, &sys->model->force) != EOM_OK) return sys->report.status;
  for (int i = 0; i < n; i++) {
    const tl_real *row = ws->jet_out + (size_t)i * (size_t)shape->ncoef + shape->start[1];
    for (int j = 0; j < 2 * n; j++) ws->rhs1[j * n + i] += row[j];
  }
  return EOM_OK;
}

/* rhs1 -= d2D/dqd dy. */
static eom_status linearise_dissipation(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_workspace *ws = sys->workspace;
  const int n = sys->n;
  eom_stage_seed(sys, STAGE_DISSIPATION_LINEARISE, q, qd, NULL, t);
  if (eom_stage_run(sys, &sys->model->dissipation) != EOM_OK) return sys->report.status;
  const second_order h = second_order_at(ws->stage[STAGE_DISSIPATION_LINEARISE].shape, ws->jet_out, 0);
  for (int j = 0; j < 2 * n; j++)
    for (int i = 0; i < n; i++) ws->rhs1[j * n + i] -= derivative(h, n + i, j);
  return EOM_OK;
}

/* rhs2 = -dphi''/dy. */
static eom_status linearise_holonomic(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_workspace *ws = sys->workspace;
  const tl_shape *shape = ws->stage[STAGE_HOLONOMIC].shape;
  const int n = sys->n, m = sys->m;
  eom_stage_seed(sys, STAGE_HOLONOMIC, q, qd, sys->qdd, t);
  for (int f = 0, r = 0; f < sys->model->nholonomic; f++) {
    const eom_function *phi = &sys->model->holonomic[f];
    if (eom_stage_run(sys, phi) != EOM_OK) return sys->report.status;
    const int rows = phi->rows(sys->params);
    for (int i = 0; i < rows; i++, r++) {
      const tl_real *row_s = ws->jet_out + (size_t)i * (size_t)shape->ncoef + shape->start[1] + n, *row_s2 = row_s + n;
      for (int j = 0; j < n; j++) {
        ws->rhs2[j * m + r] = TL_C(-2.0) * row_s2[j];
        ws->rhs2[(n + j) * m + r] = TL_C(-2.0) * row_s[j];
      }
    }
  }
  return EOM_OK;
}

/* rhs1 += d(A'lambda)/dq. */
static eom_status linearise_constraint_force(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_workspace *ws = sys->workspace;
  const tl_shape *shape = ws->stage[STAGE_CURVATURE].shape;
  const int n = sys->n;
  eom_stage_seed(sys, STAGE_CURVATURE, q, qd, NULL, t);
  for (int f = 0, r = 0; f < sys->model->nholonomic; f++) {
    const eom_function *phi = &sys->model->holonomic[f];
    if (eom_stage_run(sys, phi) != EOM_OK) return sys->report.status;
    const int rows = phi->rows(sys->params);
    for (int k = 0; k < rows; k++, r++) {
      const second_order h = second_order_at(shape, ws->jet_out + (size_t)k * (size_t)shape->ncoef, 0);
      for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++) ws->rhs1[j * n + i] += sys->lambda[r] * derivative(h, i, j);
    }
  }
  return EOM_OK;
}

eom_status eom_linearised_terms(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  if (linearise_motion(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (sys->model->force.jet && linearise_force(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (sys->model->dissipation.jet && linearise_dissipation(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (sys->m1 > 0 && linearise_holonomic(sys, q, qd, t) != EOM_OK) return sys->report.status;
  return sys->m1 > 0 ? linearise_constraint_force(sys, q, qd, t) : EOM_OK;
}

static eom_status linearise_by_calls(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  if (eom_linearised_terms(sys, q, qd, t) != EOM_OK) return sys->report.status;
  const eom_workspace *ws = sys->workspace;
  const int n = sys->n, m = sys->m;
  for (int j = 0; j < 2 * n; j++) {
    for (int i = 0; i < n; i++) sys->qdd_y[i * 2 * n + j] = -ws->rhs1[j * n + i];
    for (int r = 0; r < m; r++) sys->lambda_y[r * 2 * n + j] = -ws->rhs2[j * m + r];
  }
  return EOM_OK;
}

/* Rows of G from the first derivatives by q of a list of functions, at one power of s. */
static eom_status read_rates(eom_system *sys, tl_real *G, const eom_function *list, int count, int s) {
  const eom_workspace *ws = sys->workspace;
  const int n = sys->n;
  for (int f = 0; f < count; f++) {
    if (eom_stage_run(sys, &list[f]) != EOM_OK) return sys->report.status;
    const tl_shape *shape = ws->cx.shape;
    const int rows = list[f].rows(sys->params);
    for (int i = 0; i < rows; i++, G += n)
      memcpy(G, ws->jet_out + i * shape->ncoef + shape->start[1] + s * n, (size_t)n * sizeof(tl_real));
  }
  return EOM_OK;
}

/* [s x] phi above [x] psi. */
eom_status eom_constraint_rates(eom_system *sys, tl_real *G, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_model *model = sys->model;
  if (sys->m1 > 0) {
    eom_stage_seed(sys, STAGE_HOLONOMIC, q, qd, NULL, t);
    if (read_rates(sys, G, model->holonomic, model->nholonomic, 1) != EOM_OK) return sys->report.status;
  }
  if (sys->m2 == 0) return EOM_OK;
  eom_stage_seed(sys, STAGE_NONHOLONOMIC_Q, q, qd, NULL, t);
  return read_rates(sys, G + sys->m1 * sys->n, model->nonholonomic, model->nnonholonomic, 0);
}

/* ---- by either emitter ---- */

static eom_status linearise_by_motion(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const int code =
      sys->motion->linearise(sys->params, q, qd, t, sys->qdd, sys->lambda, sys->qdd_y, sys->lambda_y, sys->workspace->motion_work);
  return eom_motion_verdict(sys, code, q, qd, t);
}

/* EOM_MOTION_PIVOT also where there is no solved form. */
static int solved_form(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  if (!eom_by_motion(sys, EOM_TASK_LINEARISE) || !sys->motion->jacobian) return EOM_MOTION_PIVOT;
  return sys->motion->jacobian(sys->params, q, qd, t, sys->qdd, sys->qdd_y, sys->workspace->motion_work);
}

eom_status eom_linearise(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  assert(sys);
  if (eom_start_needing(sys, EOM_NEED_LINEARISE, q, qd, t) != EOM_OK) return sys->report.status;
  const int code = solved_form(sys, q, qd, t);
  return code == EOM_MOTION_PIVOT ? eom_linearise_factored(sys, q, qd, t) : eom_solved_by_motion(sys, code, q, qd, t);
}

eom_status eom_linearised_residual(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  return eom_by_motion(sys, EOM_TASK_LINEARISE) ? linearise_by_motion(sys, q, qd, t) : linearise_by_calls(sys, q, qd, t);
}

eom_status eom_linearise_factored(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  if (eom_solve_at(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (eom_linearised_residual(sys, q, qd, t) != EOM_OK) return sys->report.status;
  const int n = sys->n;
  if (eom_stabilise_derivatives(sys, sys->lambda_y, 2 * n, NULL, q, qd, t) != EOM_OK) return sys->report.status;
  eom_solve_columns(sys, 2 * n, sys->qdd_y, sys->lambda_y);
  if (eom_check_finite(sys, "derivative of the accelerations", sys->qdd_y, 2 * n * n) != EOM_OK) return sys->report.status;
  return eom_check_finite(sys, "derivative of the multipliers", sys->lambda_y, 2 * n * sys->m);
}

void eom_state_matrix(const eom_system *sys, tl_real *F) {
  const int n = sys->n;
  memset(F, 0, 2 * (size_t)n * (size_t)n * sizeof(tl_real));
  for (int i = 0; i < n; i++) F[i * 2 * n + n + i] = TL_C(1.0);
  memcpy(F + 2 * n * n, sys->qdd_y, 2 * (size_t)n * (size_t)n * sizeof(tl_real));
}
