/* Derivatives of accelerations and multipliers in directions of the state, and with respect to parameters, at a cost that grows with
 * the number of directions: d qdd/d(q,qd) is never formed where the system has the motion functions for it. */
#ifndef EOM_TANGENT_H
#define EOM_TANGENT_H

#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Accelerations at (q, qd, t) as eom_acceleration; with them their derivatives in k >= 1 directions, the columns of w (2n x k):
 * dqdd = d qdd/d(q,qd) w: n x k, dlambda = d lambda/d(q,qd) w: m x k, null where m = 0. The system must have EOM_NEED_TANGENT; by calls
 * it linearises and multiplies. Errors of eom_linearise. */
eom_status eom_tangent(eom_system *sys, tl_real *dqdd, tl_real *dlambda, int k, const tl_real *w, const tl_real *q, const tl_real *qd,
                       tl_real t);

/* Accelerations as above; with them qdd_p = d qdd/dp: n x np and lambda_p = d lambda/dp: m x np, null where m = 0, for the np
 * parameters that sys->motion->parameter names. The system must have EOM_NEED_PARAMETERS, which only motion functions serve. Errors of
 * eom_acceleration. */
eom_status eom_parameter_derivatives(eom_system *sys, tl_real *qdd_p, tl_real *lambda_p, const tl_real *q, const tl_real *qd,
                                     tl_real t);

#ifdef __cplusplus
}
#endif

#endif
