/* Lagrangian of the spring pendulum. */
#include "spring_pendulum.h"

#include <math.h>

/* Position and velocity in the plane from polar coordinates; y points up. */
static void polar(const double q[2], const double qd[2], double pos[2], double vel[2]) {
  const double s = sin(q[1]), c = cos(q[1]);

  pos[0] = q[0] * s;
  pos[1] = -q[0] * c;
  vel[0] = qd[0] * s + q[0] * qd[1] * c;
  vel[1] = -qd[0] * c + q[0] * qd[1] * s;
}

double spring_pendulum_lagrangian(const double *q, const double *qd, const struct spring_pendulum *p) {
  const double stretch = q[0] - p->rest;
  double pos[2], vel[2];

  polar(q, qd, pos, vel);
  return 0.5 * p->mass * (vel[0] * vel[0] + vel[1] * vel[1]) - p->mass * p->gravity * pos[1] - 0.5 * p->stiffness * stretch * stretch;
}
