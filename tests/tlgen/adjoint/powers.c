/* Powers with exponents that are known at run time only: whole, half and negative ones, at negative bases, at zero and of a counter. */
#include <math.h>

struct powers {
  int degree;
  double square, contact, inverse, shape; /* whole; not whole; whole and negative; any */
};

double powers_lagrangian(const double *q, const double *qd, const struct powers *p) {
  double energy = pow(qd[0], p->square) + pow(qd[1] + 0.5 * q[0], p->square);
  energy -= pow(fmax(q[0], 0.0), p->contact) * (1.0 + 0.25 * qd[1]); /* the base is 0 where there is no contact */
  energy -= pow(q[1] - 2.0, p->inverse) + pow(fmax(q[1], 0.0), p->square);
  energy += pow(1.5 + q[0] * q[1], p->shape + q[1]) + pow(1.5 + q[0] * q[1], p->shape) * pow(p->shape, qd[0]);
  for (int i = 0; i < p->degree; i++) energy += pow(fmin(q[1], 0.0) + 0.1 * i * q[0], i) + pow(2.0 - q[0], 1 - i);
  return energy;
}
