/* How two poles get from hanging to standing: a motion of the machine, and what it costs to be beside it, at knots that plan.c has
 * computed and that stand in flash. */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "plant.h"

enum {
  REFERENCE_KNOT_STEPS = 40, /* control steps from a knot to the next */
  REFERENCE_KNOTS = 76,
  REFERENCE_STEPS = REFERENCE_KNOT_STEPS * (REFERENCE_KNOTS - 1),
  REFERENCE_PARTS = D * (D + 1) / 2
};

typedef struct reference_knot {
  float push; /* N, until the next knot */
  float y[D];
  float X[REFERENCE_PARTS]; /* the upper half, by rows, of the matrix of the cost e' X e of all steps from here on */
} reference_knot;

extern const reference_knot reference_table[REFERENCE_KNOTS];

/* The state (D numbers) and the push at a control step from 0 to REFERENCE_STEPS: coordinates by Hermite's cubics, velocities as their
 * derivatives. */
void reference_motion(int step, tl_real *y, tl_real *push);

/* The cost's matrix X (D x D), likewise, linear between knots: so it stays positive definite. */
void reference_cost(int step, tl_real *X);

#endif
