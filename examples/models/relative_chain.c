/* Lagrangian of a chain in relative angles: a walk down the chain that adds up angle, rate, velocity and height. */
#include "relative_chain.h"

#include <math.h>

double relative_chain_lagrangian(const double *q, const double *qd, const struct relative_chain *p) {
  const double *end = q + p->n;
  double angle = 0, rate = 0, u = 0, v = 0, height = 0, L = 0;

  while (q != end) {
    angle += *q++;
    rate += *qd++;
    u += rate * cos(angle);
    v += rate * sin(angle);
    height -= cos(angle);
    L += (u * u + v * v) / 2 - p->gravity * height;
  }
  return L;
}
