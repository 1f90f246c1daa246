/* Assembly of the equations of motion from the Lagrangian and the constraint functions (eqs 26, 30): by motion
 * functions where the system has them, else by forward jets. */
#ifndef EOM_ASSEMBLE_H
#define EOM_ASSEMBLE_H

#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Fills momentum, momentum_rate, lagrangian and energy of *sys at (q, qd, t): E = dL/dqd . qd - L. q, qd: n. DOMAIN, NOT_FINITE,
 * SIZES_CHANGED. */
eom_status eom_energy(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* Fills every assemble field of *sys at (q, qd, t), energy included. q, qd: n.
 * DOMAIN where a model function does not exist at the state, NOT_FINITE, SIZES_CHANGED; sys->report says which and where. */
eom_status eom_assemble(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t);

/* Inverse dynamics: r = M qdd - Q at (q, qd, qdd, t), the generalized forces that qdd needs beside Gamma (constraint forces among
 * them). r, qdd, q, qd: n. The system must have EOM_NEED_RESIDUAL. Errors of eom_assemble. */
eom_status eom_residual(eom_system *sys, tl_real *r, const tl_real *qdd, const tl_real *q, const tl_real *qd, tl_real t);

#ifdef __cplusplus
}
#endif

#endif
