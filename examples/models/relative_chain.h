/* A chain of n point masses in a vertical plane, each angle relative to the link before it; unit masses and lengths. */
#ifndef RELATIVE_CHAIN_H
#define RELATIVE_CHAIN_H

struct relative_chain {
  int n;          /* links */
  double gravity; /* m/s^2 */
};

/* q: n relative angles, rad; the first from the downward vertical. */
double relative_chain_lagrangian(const double *q, const double *qd, const struct relative_chain *p);

#endif
