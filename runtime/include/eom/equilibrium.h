/* Equilibria and steady motions: a state on the constraints whose accelerations are zero, to linearise about. */
#ifndef EOM_EQUILIBRIUM_H
#define EOM_EQUILIBRIUM_H

#include "eom/minimal.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What may change, and what was found. */
typedef struct eom_equilibrium {
  const unsigned char *keep_q;  /* n flags: 1 for a coordinate that stays as it is; null: none */
  const unsigned char *keep_qd; /* n flags: 1 for a velocity that stays as it is; null: all of them */
  /* filled */
  int steps;                   /* of the Gauss-Newton method */
  tl_real residual;            /* the largest |qdd_i| that is left, */
  int most_qdd;                /* and whose; -1 where all are zero */
  tl_real change_q, change_qd; /* the largest change of a coordinate and of a velocity, */
  int most_q, most_qd;         /* and whose; -1 where nothing changed */
  eom_minimal linear;          /* the linear model at the state that was found; its arrays are in memory */
} eom_equilibrium;

/* Bytes of memory for eom_find_equilibrium. */
size_t eom_equilibrium_bytes(const eom_system *sys);

/* Moves (q, qd), near the state given, until qdd(q, qd, t) = 0 on the constraints. With qd = 0, all kept, that is a static equilibrium,
 * stable or not; with velocities of ignorable coordinates that are not zero a steady motion, at which other coordinates, and velocities
 * that are not kept, take the values that it needs. What the accelerations do not depend on changes least, by the norm of minimal
 * coordinates (eom/minimal.h). q, qd: n, changed in place, and as they were where the status is not OK. The system must have
 * EOM_NEED_LINEARISE and afterwards holds what eom_linearise gives at the state found; with another status these are unspecified.
 *
 * NO_EQUILIBRIUM where the accelerations cannot be made less although they are not zero: nothing holds the mechanism in the direction
 * of coordinate report.index, or there is no equilibrium near. INCONSISTENT, NO_CONSISTENT_STATE where what is kept leaves no state
 * that satisfies the constraints; NO_MEMORY; errors of eom_linearise. */
eom_status eom_find_equilibrium(eom_system *sys, tl_real *q, tl_real *qd, tl_real t, eom_equilibrium *equilibrium, void *memory,
                                size_t bytes);

#ifdef __cplusplus
}
#endif

#endif
