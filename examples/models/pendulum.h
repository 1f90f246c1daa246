/* The planar N-pendulum: point masses on massless rods, hung from a fixed pivot. */
#ifndef PENDULUM_H
#define PENDULUM_H

#define PENDULUM_MAX_LINKS 64

struct pendulum {
  int n;                             /* number of links, 1..PENDULUM_MAX_LINKS */
  double g;                          /* gravity, m/s^2 */
  double mass[PENDULUM_MAX_LINKS];   /* mass at the end of each link, kg */
  double length[PENDULUM_MAX_LINKS]; /* length of each link, m */
};

/* L = T - V in J. q: angle of each link from the downward vertical, rad (n); qd: rates, rad/s (n); t: time, s (the system does not
 * depend on it). */
double pendulum_lagrangian(const double *q, const double *qd, double t, const struct pendulum *p);

#endif
