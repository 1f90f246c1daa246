/* What the stages of one evaluation share: its start, motion functions and their failures, and the parts of the equations. */
#ifndef EOM_EVALUATE_H
#define EOM_EVALUATE_H

#include "workspace.h"

/* Decides which tasks of the system's needs motion functions serve: sets sys->motion and ws->emitter. False where options.emitter asks
 * for functions that are not there. */
bool eom_choose_emitters(eom_system *sys, eom_workspace *ws);

bool eom_by_motion(const eom_system *sys, eom_task task);

/* Whether the model has the sizes that the system was started with. */
bool eom_sizes_hold(const eom_system *sys);

/* Clears the report and checks that the model has the system's sizes, and that the arguments are finite. */
eom_status eom_start(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* The same but for the sizes, which the motion function that is called next looks at itself (EOM_MOTION_SIZE). */
eom_status eom_start_sized(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* As eom_start for what the system must have been asked for: BAD_OPTION without that bit of options.needs. */
eom_status eom_start_needing(eom_system *sys, unsigned need, const tl_real *q, const tl_real *qd, tl_real t);

/* The largest |x_i - was_i| of n, and in *most whose; 0 and -1 where nothing changed. */
tl_real eom_largest_change(int n, const tl_real *x, const tl_real *was, int *most);

/* What a motion function returned at a state, as a status with its report. */
eom_status eom_motion_verdict(eom_system *sys, int code, const tl_real *q, const tl_real *qd, tl_real t);

/* M, Q, A, b, phi, phi_dot, psi at a state: all that eom_solve needs and, by motion functions, no more. */
eom_status eom_assemble_parts(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* The size of the terms that cancel in b, which motion functions do not say: what tells dependent rows that contradict each other from
 * rounding. Calls of the holonomic constraints. */
eom_status eom_size_rows(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* G = d(phi_dot, psi)/dq: m x n, by calls. */
eom_status eom_constraint_rates(eom_system *sys, tl_real *G, const tl_real *q, const tl_real *qd, tl_real t);

/* Factors M and the rows that the last projection found independent, where the rank is held; else all rows. Errors of eom_factor_make;
 * RANK_FELL. */
eom_status eom_factor_rows(eom_system *sys);

/* eom_assemble_parts, then eom_solve: afterwards the factors serve further right-hand sides. */
eom_status eom_solve_at(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* Fills row_kind and the report's rows after a factorisation: the first rank rows in its order of exchange are independent. Returns
 * report.status. */
eom_status eom_mark_rows(eom_system *sys, int rank);

/* Calls for ws->rhs1 = -d(r - A' lambda)/dy (2n vectors of n) and ws->rhs2 = -d(A qdd - b)/dy (2n vectors of m) at sys->qdd and
 * sys->lambda. */
eom_status eom_linearised_terms(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* sys->qdd_y = d(r - A' lambda)/dy and sys->lambda_y = d(A qdd - b)/dy at sys->qdd and sys->lambda, whatever these are. */
eom_status eom_linearised_residual(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* eom_linearise by the general solver: afterwards the assembled parts and the factors are those of the state. */
eom_status eom_linearise_factored(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* What a solved form of the motion functions returned, as a status with the report of a solution. */
eom_status eom_solved_by_motion(eom_system *sys, int code, const tl_real *q, const tl_real *qd, tl_real t);

/* X and Y of M X - A' Y = -r, A X = -g with the factors of the last solve, in the places of r (n x k) and g (m x k). */
void eom_solve_columns(eom_system *sys, int k, tl_real *r, tl_real *g);

#endif
