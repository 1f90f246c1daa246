/* Accelerations and constraint forces of the assembled equations (eqs 30-32), sound for singular M and dependent rows. */
#ifndef EOM_SOLVE_H
#define EOM_SOLVE_H

#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Solves M qdd = Q + A' lambda, A qdd = b for the numbers in *sys; fills qdd, lambda, Qc, row_kind and the report.
 * NO_INERTIA where [M; A] is singular (report.index: a coordinate that can move without inertia), INCONSISTENT (report.row: the rows),
 * NOT_FINITE. */
eom_status eom_solve(eom_system *sys);

/* Accelerations at (q, qd, t): fills qdd, lambda, Qc, row_kind and the report, and leaves the fields of assemble unspecified: motion
 * functions of a model without constraints need none of them. Errors of eom_assemble and eom_solve; SIZES_CHANGED. */
eom_status eom_acceleration(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* ydot = f(t,y) with y = (q,qd): 2n, as a right-hand side for integrators; user is the eom_system. Returns an eom_status. */
int eom_rhs(void *user, tl_real t, const tl_real *y, tl_real *ydot);

#ifdef __cplusplus
}
#endif

#endif
