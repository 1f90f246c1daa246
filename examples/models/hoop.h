/* A bead on a circular hoop that turns about its vertical diameter and is spun up from rest; q = the bead's angle from the bottom. */
#ifndef HOOP_H
#define HOOP_H

struct hoop {
  double mass;    /* of the bead, kg */
  double radius;  /* m */
  double gravity; /* m/s^2 */
  double spin;    /* rate about the vertical once spun up, rad/s */
  double ramp;    /* time to spin up, s */
};

double hoop_lagrangian(const double *q, const double *qd, double t, const struct hoop *p);

#endif
