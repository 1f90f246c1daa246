/* Lagrangian of a bead on a rotating hoop; time enters through the hoop's rate. */
#include "hoop.h"

#include <math.h>

/* The rate of the hoop: a smooth ramp from rest, then constant. */
static double hoop_rate(double t, const struct hoop *p) {
  double x = t / p->ramp;
  return x >= 1.0 ? p->spin : x <= 0.0 ? 0.0 : p->spin * x * x * (3.0 - 2.0 * x);
}

double hoop_lagrangian(const double *q, const double *qd, double t, const struct hoop *p) {
  double along = p->radius * qd[0];
  double around = p->radius * sin(q[0]) * hoop_rate(t, p);
  double height = p->radius * (1.0 - cos(q[0]));

  return 0.5 * p->mass * (along * along + around * around) - p->mass * p->gravity * height;
}
