/* The planar N-pendulum in closed form in __float128. */
#ifndef TEST_PENDULUM_TRUTH_H
#define TEST_PENDULUM_TRUTH_H

/* n links of 1 m with 1 kg at their ends, g in m/s2: qdd (n), its derivative dqdd_dy (n x 2n) and the energy from hand-derived formulas
 * in quadruple precision; each may be null. */
void pendulum_truth(int n, double g, const double *q, const double *qd, double *qdd, double *dqdd_dy, double *energy);

#endif
