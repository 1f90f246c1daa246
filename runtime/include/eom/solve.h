/* Accelerations and constraint forces of the assembled equations (eqs 30-32), sound for singular M and dependent rows. */
#ifndef EOM_SOLVE_H
#define EOM_SOLVE_H

#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Solves M qdd = Q + A' lambda, A qdd = b for the numbers in *sys; fills qdd, lambda, Qc, row_kind and the report.
 * NO_INERTIA where [M; A] is singular (report.index: a coordinate that can move without inertia), INCONSISTENT (report.row: the rows),
 * RANK_FELL where rows held by options.hold are dependent at this state (report.row), NOT_FINITE. */
eom_status eom_solve(eom_system *sys);

/* More right-hand sides for the factorisation of the last eom_solve: M X = R + A' Y, A X = G, for k >= 1 columns at once, with the
 * signs of qdd and lambda. x: n x k, R before and X after; y: m x k, G before and Y after, null where m = 0. M, A and the system must
 * be as that eom_solve found them: nothing else was evaluated in between, and it was EOM_OK. The system must have EOM_NEED_LINEARISE,
 * EOM_NEED_TANGENT or EOM_NEED_PARAMETERS. Where rows are dependent A X = G holds in the sense of least squares (rows scaled to unit
 * length in the mass metric), and Y is of least norm, as lambda. NOT_FINITE (report.function: "right-hand side" or "solution"). */
eom_status eom_solve_more(eom_system *sys, int k, tl_real *x, tl_real *y);

/* Accelerations at (q, qd, t): fills qdd, lambda, Qc, row_kind and the report, and leaves the fields of assemble unspecified: motion
 * functions of a model without constraints need none of them. Errors of eom_assemble and eom_solve; SIZES_CHANGED. */
eom_status eom_acceleration(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* ydot = f(t,y) with y = (q,qd): 2n, as a right-hand side for integrators; user is the eom_system. Returns an eom_status. */
int eom_rhs(void *user, tl_real t, const tl_real *y, tl_real *ydot);

#ifdef __cplusplus
}
#endif

#endif
