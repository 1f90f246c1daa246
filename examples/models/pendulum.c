/* Lagrangian of the planar N-pendulum in absolute angles. */
#include "pendulum.h"

#include <math.h>

double pendulum_lagrangian(const double *q, const double *qd, double t, const struct pendulum *p) {
  double vx = 0.0, vy = 0.0; /* velocity of the mass at hand, m/s */
  double height = 0.0;       /* its height above the pivot, m */
  double T = 0.0, V = 0.0;
  (void)t;

  for (int k = 0; k < p->n; k++) {
    double s = sin(q[k]), c = cos(q[k]);

    vx += p->length[k] * c * qd[k];
    vy += p->length[k] * s * qd[k];
    height -= p->length[k] * c;
    T += 0.5 * p->mass[k] * (vx * vx + vy * vy);
    V += p->mass[k] * p->g * height;
  }
  return T - V;
}
