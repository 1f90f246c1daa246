/* The exact linearised equations of motion, constrained or not (eqs 83-89), also in the user's own coordinates (eq 46). */
#ifndef EOM_LINEARISE_H
#define EOM_LINEARISE_H

#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Accelerations at (q, qd, t) as eom_acceleration; with them qdd_y = d qdd/d(q,qd) and lambda_y = d lambda/d(q,qd) with the same
 * factorisation. The system must have EOM_NEED_LINEARISE. Errors as eom_acceleration. */
eom_status eom_linearise(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* F = df/dy = [0 I; qdd_y] of the last eom_linearise. F: 2n x 2n. */
void eom_state_matrix(const eom_system *sys, tl_real *F);

/* A point transformation v(q,t) and its inverse q(v,t) as jet functions of n rows. As jet functions both find their argument in the
 * place of q; qd is not to be used. params of the system are passed on. */
typedef struct eom_coordinates {
  eom_function v_of_q;
  eom_function q_of_v;
} eom_coordinates;

/* The state matrix of z = (v, vdot) at (q, qd, t): dz' = F_z dz with F_z = [D2Z f + DZ F] DZ^-1 (eq 46); DZ^-1 from the derivative of
 * the given inverse. F_z: 2n x 2n; z: 2n, may be null. Workspace of eom_coordinates_bytes in memory.
 * NOT_INVERSE where q(v(q)) differs from q, or the product of the derivatives from 1, by more than rounding; errors of eom_linearise.
 */
size_t eom_coordinates_bytes(const eom_system *sys, const eom_coordinates *coordinates);
eom_status eom_linearise_in(eom_system *sys, const eom_coordinates *coordinates, tl_real *F_z, tl_real *z, const tl_real *q,
                            const tl_real *qd, tl_real t, void *memory, size_t bytes);

#ifdef __cplusplus
}
#endif

#endif
