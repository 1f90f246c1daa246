/* A mass on a spring that swings in a plane; q = (r, theta): length of the spring, m; angle from the downward vertical, rad. */
#ifndef SPRING_PENDULUM_H
#define SPRING_PENDULUM_H

struct spring_pendulum {
  double mass;      /* kg */
  double rest;      /* length of the spring at rest, m */
  double stiffness; /* N/m */
  double gravity;   /* m/s^2 */
};

double spring_pendulum_lagrangian(const double *q, const double *qd, const struct spring_pendulum *p);

#endif
