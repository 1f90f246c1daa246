/* Derivatives in directions and with respect to parameters: M dqdd - A' dlambda = -dr, A dqdd = -dg with the factors of the motion. */
#include "eom/tangent.h"

#include "baumgarte.h"
#include "eom/linearise.h"
#include "evaluate.h"
#include "stage.h"
#include "tangent_flow.h"

#include <assert.h>
#include <string.h>

/* ---- which way ---- */

/* The solved form of all derivatives and a product cost less than directions one by one from so many on, in parts of n: measured from 2
 * to 16 coordinates without constraints. */
static const tl_real many = TL_C(0.5);

static bool has_solved_form(const eom_system *sys) { return eom_by_motion(sys, EOM_TASK_LINEARISE) && sys->motion->jacobian; }

/* By way of derivatives in all directions. */
static bool by_linearising(const eom_system *sys, int k) {
  if (!eom_by_motion(sys, EOM_TASK_TANGENT)) return true;
  if (!(sys->options.needs & EOM_NEED_LINEARISE)) return false;
  const tl_real least = has_solved_form(sys) ? many * (tl_real)sys->n : TL_C(2.0) * (tl_real)sys->n;
  return (tl_real)k > least;
}

/* ---- by solved forms, without constraints ---- */

/* EOM_MOTION_PIVOT also where there is none. */
static int solved_form(eom_system *sys, tl_real *dqdd, int k, const tl_real *w, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_motion *motion = sys->motion;
  tl_real *work = sys->workspace->motion_work;
  if (!by_linearising(sys, k))
    return motion->directional ? motion->directional(sys->params, q, qd, t, k, w, sys->qdd, dqdd, work) : EOM_MOTION_PIVOT;
  if (!has_solved_form(sys)) return EOM_MOTION_PIVOT;
  const int code = motion->jacobian(sys->params, q, qd, t, sys->qdd, sys->qdd_y, work);
  if (code == 0) eom_multiply(sys->n, 2 * sys->n, k, dqdd, sys->qdd_y, w);
  return code;
}

/* ---- by the general solver ---- */

/* dr = d(r - A' lambda)/dy w: n x k and dg = d(A qdd - b)/dy w: m x k, at the solved qdd and lambda. */
static eom_status residual_columns(eom_system *sys, tl_real *dr, tl_real *dg, int k, const tl_real *w, const tl_real *q,
                                   const tl_real *qd, tl_real t) {
  if (!by_linearising(sys, k)) {
    const int code = sys->motion->tangent(sys->params, q, qd, t, sys->qdd, sys->lambda, k, w, dr, dg, sys->workspace->motion_work);
    return eom_motion_verdict(sys, code, q, qd, t);
  }
  if (eom_linearised_residual(sys, q, qd, t) != EOM_OK) return sys->report.status;
  eom_multiply(sys->n, 2 * sys->n, k, dr, sys->qdd_y, w);
  eom_multiply(sys->m, 2 * sys->n, k, dg, sys->lambda_y, w);
  return EOM_OK;
}

/* r_p: n x np and g_p: m x np of all parameters, likewise. */
static eom_status residual_parameters(eom_system *sys, tl_real *r_p, tl_real *g_p, const tl_real *q, const tl_real *qd, tl_real t) {
  const int code = sys->motion->parameters(sys->params, q, qd, t, sys->qdd, sys->lambda, r_p, g_p, sys->workspace->motion_work);
  return eom_motion_verdict(sys, code, q, qd, t);
}

static eom_status check_derivatives(eom_system *sys, int k, const tl_real *dqdd, const tl_real *dlambda) {
  if (eom_check_finite(sys, "derivative of the accelerations", dqdd, sys->n * k) != EOM_OK) return sys->report.status;
  return eom_check_finite(sys, "derivative of the multipliers", dlambda, sys->m * k);
}

/* ---- what others call ---- */

eom_status eom_tangent(eom_system *sys, tl_real *dqdd, tl_real *dlambda, int k, const tl_real *w, const tl_real *q, const tl_real *qd,
                       tl_real t) {
  assert(dqdd && (dlambda || sys->m == 0) && k > 0 && w);
  if (eom_start_needing(sys, EOM_NEED_TANGENT, q, qd, t) != EOM_OK) return sys->report.status;
  const eom_columns columns = {.k = k, .work = dlambda};
  return eom_tangents(sys, &columns, dqdd, w, q, qd, t);
}

eom_status eom_parameter_derivatives(eom_system *sys, tl_real *qdd_p, tl_real *lambda_p, const tl_real *q, const tl_real *qd,
                                     tl_real t) {
  assert(qdd_p && (lambda_p || sys->m == 0));
  if (eom_start_needing(sys, EOM_NEED_PARAMETERS, q, qd, t) != EOM_OK || eom_solve_at(sys, q, qd, t) != EOM_OK)
    return sys->report.status;
  if (residual_parameters(sys, qdd_p, lambda_p, q, qd, t) != EOM_OK) return sys->report.status;
  eom_solve_columns(sys, sys->motion->np, qdd_p, lambda_p);
  return check_derivatives(sys, sys->motion->np, qdd_p, lambda_p);
}

/* ---- columns of both kinds ---- */

/* dlambda; then r_p and g_p of all parameters. */
size_t eom_columns_size(const eom_system *sys, int k, int np) {
  const size_t all = np > 0 ? (size_t)sys->motion->np : 0;
  return (size_t)sys->m * (size_t)k + ((size_t)sys->n + (size_t)sys->m) * all;
}

/* Adds the columns of the chosen parameters to the last ones of dr, rows x k. */
static void add_parameters(const eom_system *sys, const eom_columns *c, int rows, tl_real *dr, const tl_real *r_p) {
  const int all = sys->motion->np, first = c->k - c->np;
  for (int i = 0; i < rows; i++)
    for (int j = 0; j < c->np; j++) dr[i * c->k + first + j] += r_p[i * all + (c->parameter ? c->parameter[j] : j)];
}

static eom_status tangents_by_factors(eom_system *sys, const eom_columns *c, tl_real *dqdd, const tl_real *w, const tl_real *q,
                                      const tl_real *qd, tl_real t) {
  const int n = sys->n, m = sys->m, k = c->k;
  tl_real *dlambda = c->work;
  if (eom_solve_at(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (residual_columns(sys, dqdd, dlambda, k, w, q, qd, t) != EOM_OK) return sys->report.status;
  if (c->np > 0) {
    tl_real *r_p = c->work + m * k, *g_p = r_p + n * sys->motion->np;
    if (residual_parameters(sys, r_p, g_p, q, qd, t) != EOM_OK) return sys->report.status;
    add_parameters(sys, c, n, dqdd, r_p);
    add_parameters(sys, c, m, dlambda, g_p);
  }
  if (eom_stabilise_derivatives(sys, dlambda, k, w, q, qd, t) != EOM_OK) return sys->report.status;
  eom_solve_columns(sys, k, dqdd, dlambda);
  return check_derivatives(sys, k, dqdd, dlambda);
}

eom_status eom_tangents(eom_system *sys, const eom_columns *c, tl_real *dqdd, const tl_real *w, const tl_real *q, const tl_real *qd,
                        tl_real t) {
  if (eom_start_needing(sys, EOM_NEED_TANGENT | EOM_NEED_LINEARISE, q, qd, t) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "argument w", w, 2 * sys->n * c->k) != EOM_OK) return sys->report.status;
  const int code = c->np > 0 ? EOM_MOTION_PIVOT : solved_form(sys, dqdd, c->k, w, q, qd, t);
  if (code == EOM_MOTION_PIVOT) return tangents_by_factors(sys, c, dqdd, w, q, qd, t);
  if (eom_solved_by_motion(sys, code, q, qd, t) != EOM_OK) return sys->report.status;
  return eom_check_finite(sys, "derivative of the accelerations", dqdd, sys->n * c->k);
}

eom_status eom_tangent_flow(eom_system *sys, const eom_columns *c, tl_real t, const tl_real *z, tl_real *zdot) {
  const size_t n = (size_t)sys->n, k = (size_t)c->k;
  const tl_real *w = z + 2 * n;
  tl_real *wdot = zdot + 2 * n;
  if (eom_tangents(sys, c, wdot + n * k, w, z, z + n, t) != EOM_OK) return sys->report.status;
  memcpy(zdot, z + n, n * sizeof(tl_real));
  memcpy(zdot + n, sys->qdd, n * sizeof(tl_real));
  memcpy(wdot, w + n * k, n * k * sizeof(tl_real));
  return EOM_OK;
}
