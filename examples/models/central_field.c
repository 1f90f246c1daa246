/* Lagrangian and constraint of a particle in a central field, position r u with a unit vector u. */
#include "central_field.h"

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static double potential(double r, const struct central_field *p) { return -p->mu * p->m / r; }

double central_field_lagrangian(const double *q, const double *qd, const struct central_field *p) {
  const double r = q[0], *u = q + 1;
  const double rd = qd[0], *ud = qd + 1;
  double v[3]; /* d(r u)/dt */

  for (int i = 0; i < 3; i++) v[i] = rd * u[i] + r * ud[i];
  return 0.5 * p->m * dot(v, v) - potential(r, p);
}

double central_field_reduced_lagrangian(const double *q, const double *qd, const struct central_field *p) {
  const double r = q[0], rd = qd[0], *ud = qd + 1;

  return 0.5 * p->m * (rd * rd + r * r * dot(ud, ud)) - potential(r, p);
}

double central_field_unit(const double *q) { return dot(q + 1, q + 1) - 1.0; }
