/* The planar N-pendulum in absolute angles: jet model by hand, and the same in closed form in __float128. */
#ifndef TEST_PENDULUM_MODEL_H
#define TEST_PENDULUM_MODEL_H

#include "eom/model.h"

typedef struct pendulum {
  int n;
  tl_real g; /* m/s2; links of 1 m with 1 kg at their ends */
} pendulum;

extern const eom_model pendulum_model; /* params: struct pendulum */

/* qdd (n), its derivative dqdd_dy (n x 2n) and the energy from hand-derived formulas in quadruple precision; either may be null. */
void pendulum_truth(const pendulum *p, const double *q, const double *qd, double *qdd, double *dqdd_dy, double *energy);

#endif
