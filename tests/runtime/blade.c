/* A blade on a circle that grows: one holonomic constraint with explicit t, one nonholonomic, drag; plain C for tlgen. */
#include "blade.h"

#include <math.h>

double blade_lagrangian(const double *q, const double *qd, const blade *p) {
  return 0.5 * p->mass * (qd[0] * qd[0] + qd[1] * qd[1]) + 0.5 * p->inertia * qd[2] * qd[2] - p->mass * q[0] * sin(q[1]);
}

double blade_circle(const double *q, double t) {
  const double radius = 1.0 + 0.1 * t;
  return q[0] * q[0] + q[1] * q[1] - radius * radius;
}

double blade_slip(const double *q, const double *qd) { return qd[0] * sin(q[2]) - qd[1] * cos(q[2]); }

void blade_drag(const double *qd, const blade *p, double *out) {
  for (int i = 0; i < 3; i++) out[i] = -0.2 * p->mass * qd[i];
}
