/* Assembly of the equations of motion from the Lagrangian and the constraint functions by forward jets (eqs 26, 30). */
#ifndef EOM_ASSEMBLE_H
#define EOM_ASSEMBLE_H

#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Fills momentum, lagrangian and energy of *sys at (q, qd, t): E = dL/dqd . qd - L. q, qd: n. DOMAIN, NOT_FINITE. */
eom_status eom_energy(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* Fills every assemble field of *sys at (q, qd, t), energy included. q, qd: n.
 * DOMAIN where a model function does not exist at the state, NOT_FINITE; sys->report says which and where. */
eom_status eom_assemble(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

#ifdef __cplusplus
}
#endif

#endif
