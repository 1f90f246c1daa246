/* Consistent states: coordinates and velocities brought onto the constraints by the least change in the mass metric. After a step this
 * takes away what integration has left over (drift); before a run it makes initial values consistent. */
#ifndef EOM_PROJECT_H
#define EOM_PROJECT_H

#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What may change, and what did. */
typedef struct eom_projection {
  int after_step; /* 1: it follows a step from the last state projected, whose rank counts with options.hold, and options.most_jump
                     bounds the change. 0: a state of its own */
  const unsigned char *keep_q, *keep_qd; /* n flags each: 1 for a coordinate, or velocity, that stays as it is; null: none */
  /* filled */
  int steps_q, steps_qd;       /* of Newton's method */
  tl_real change_q, change_qd; /* the largest change of a coordinate and of a velocity, */
  int most_q, most_qd;         /* and whose; -1 where nothing changed */
} eom_projection;

/* Moves q until phi(q,t) = 0, then qd until phi_dot = 0 and psi(q,qd,t) = 0, to rounding: each Newton step is the shortest one in the
 * mass metric, delta' M delta, that satisfies the linearised rows. Dependent rows that agree are no difficulty. With options.hold, and
 * where nothing is kept, decides on the rank for the solves that follow: sys->held_rank and rank_changes; row_kind and report.row say
 * which rows are dropped, and these may miss by take times ahead. q, qd: n, changed in place, and as they were where the status is not
 * EOM_OK. projection may be null. Leaves the fields of assemble and of solve unspecified but for row_kind. After a step that ends near
 * the rows, where these are safely independent, one factorisation serves for all Newton steps; report.condition is -1 then.
 * INCONSISTENT where rows contradict each other, or what is kept leaves no state that satisfies them (report.row: the rows that miss);
 * NO_CONSISTENT_STATE where Newton's method does not get there (likewise); VELOCITY_JUMP (report.index: the velocity that changed
 * most); NO_INERTIA; errors of eom_assemble. */
eom_status eom_project(eom_system *sys, tl_real *q, tl_real *qd, tl_real t, eom_projection *projection);

/* The same for y = (q,qd): 2n, after_step, as what an eom_integrator does; user is the eom_system. Returns an eom_status. */
int eom_project_state(void *user, tl_real t, tl_real *y);

/* What the rows allow of a change of a state, such as an error estimate: dq with A dq = 0 in the holonomic rows and dqd with A dqd = 0
 * in all of them, the nearest in the mass metric. dq, dqd: n, changed in place. Leaves the fields of assemble and of solve unspecified.
 * NO_INERTIA, NOT_FINITE (report.function: "change of a state"); errors of eom_assemble. */
eom_status eom_project_change(eom_system *sys, tl_real *dq, tl_real *dqd, const tl_real *q, const tl_real *qd, tl_real t);

#ifdef __cplusplus
}
#endif

#endif
