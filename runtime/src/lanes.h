/* Solutions for several right-hand sides at once: each number of a row belongs to one of them, so that a compiler works on a row as on
 * one number. */
#ifndef EOM_LANES_H
#define EOM_LANES_H

#include "workspace.h"

/* x and y of M x - A' y = -r, A x = -g for the k columns of r (n x k) and g (m x k), in their places, with the factors of the last
 * solve; refined as eom_kkt_solve does. Rows of full rank. */
void eom_lanes_solve(eom_system *sys, int k, tl_real *r, tl_real *g);

#endif
