/* Derivatives in directions and with respect to parameters: M dqdd - A' dlambda = -dr, A dqdd = -dg with the factors of the motion. */
#include "eom/tangent.h"

#include "baumgarte.h"
#include "eom/linearise.h"
#include "evaluate.h"
#include "stage.h"

#include <assert.h>

static eom_status tangent_by_calls(eom_system *sys, tl_real *dqdd, tl_real *dlambda, int k, const tl_real *w, const tl_real *q,
                                   const tl_real *qd, tl_real t) {
  if (eom_linearise(sys, q, qd, t) != EOM_OK) return sys->report.status;
  eom_multiply(sys->n, 2 * sys->n, k, dqdd, sys->qdd_y, w);
  eom_multiply(sys->m, 2 * sys->n, k, dlambda, sys->lambda_y, w);
  return EOM_OK;
}

static eom_status tangent_by_motion(eom_system *sys, tl_real *dqdd, tl_real *dlambda, int k, const tl_real *w, const tl_real *q,
                                    const tl_real *qd, tl_real t) {
  const eom_motion *motion = sys->motion;
  tl_real *work = sys->workspace->motion_work;
  if (motion->directional) {
    const int code = motion->directional(sys->params, q, qd, t, k, w, sys->qdd, dqdd, work);
    if (code != EOM_MOTION_PIVOT) return eom_solved_by_motion(sys, code, q, qd, t);
  }
  if (eom_solve_at(sys, q, qd, t) != EOM_OK) return sys->report.status;
  const int code = motion->tangent(sys->params, q, qd, t, sys->qdd, sys->lambda, k, w, dqdd, dlambda, work);
  if (code != 0) return eom_motion_verdict(sys, code, q, qd, t);
  if (eom_stabilise_derivatives(sys, dlambda, k, w, q, qd, t) != EOM_OK) return sys->report.status;
  eom_solve_columns(sys, k, dqdd, dlambda);
  return EOM_OK;
}

eom_status eom_tangent(eom_system *sys, tl_real *dqdd, tl_real *dlambda, int k, const tl_real *w, const tl_real *q, const tl_real *qd,
                       tl_real t) {
  assert(dqdd && (dlambda || sys->m == 0) && k > 0 && w);
  if (eom_start_needing(sys, EOM_NEED_TANGENT, q, qd, t) != EOM_OK) return sys->report.status;
  const int n = sys->n;
  if (eom_check_finite(sys, "argument w", w, 2 * n * k) != EOM_OK) return sys->report.status;
  const bool by_motion = eom_by_motion(sys, EOM_TASK_TANGENT);
  if ((by_motion ? tangent_by_motion : tangent_by_calls)(sys, dqdd, dlambda, k, w, q, qd, t) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "derivative of the accelerations", dqdd, n * k) != EOM_OK) return sys->report.status;
  return eom_check_finite(sys, "derivative of the multipliers", dlambda, sys->m * k);
}

eom_status eom_parameter_derivatives(eom_system *sys, tl_real *qdd_p, tl_real *lambda_p, const tl_real *q, const tl_real *qd,
                                     tl_real t) {
  assert(qdd_p && (lambda_p || sys->m == 0));
  if (eom_start_needing(sys, EOM_NEED_PARAMETERS, q, qd, t) != EOM_OK || eom_solve_at(sys, q, qd, t) != EOM_OK)
    return sys->report.status;
  const eom_motion *motion = sys->motion;
  const int code = motion->parameters(sys->params, q, qd, t, sys->qdd, sys->lambda, qdd_p, lambda_p, sys->workspace->motion_work);
  if (code != 0) return eom_motion_verdict(sys, code, q, qd, t);
  eom_solve_columns(sys, motion->np, qdd_p, lambda_p);
  if (eom_check_finite(sys, "derivative of the accelerations", qdd_p, sys->n * motion->np) != EOM_OK) return sys->report.status;
  return eom_check_finite(sys, "derivative of the multipliers", lambda_p, sys->m * motion->np);
}
