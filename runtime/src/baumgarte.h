/* Baumgarte's terms of the constraint rows and their derivatives; nothing where options.baumgarte is zero. */
#ifndef EOM_BAUMGARTE_H
#define EOM_BAUMGARTE_H

#include "workspace.h"

bool eom_is_stabilised(const eom_system *sys);

/* b -= 2 alpha phi' + beta^2 phi and b -= alpha psi, for rows as they were assembled. */
void eom_stabilise_holonomic(eom_system *sys);
void eom_stabilise_nonholonomic(eom_system *sys);

/* Adds to g (m x k), k columns of d(A qdd - b)/dy w, what these terms contribute. w: 2n x k; null: the unit matrix, k = 2n. Errors of
 * eom_assemble. */
eom_status eom_stabilise_derivatives(eom_system *sys, tl_real *g, int k, const tl_real *w, const tl_real *q, const tl_real *qd,
                                     tl_real t);

#endif
