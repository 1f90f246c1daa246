/* Chaplygin's sleigh: a body on a level plane that stands on a blade, with its centre of mass ahead of it; q = (x, y, heading): place of the
 * blade, m, m; rad. */
#ifndef CHAPLYGIN_SLEIGH_H
#define CHAPLYGIN_SLEIGH_H

typedef struct chaplygin_sleigh {
  double mass;    /* kg */
  double inertia; /* about the centre of mass, kg m^2 */
  double ahead;   /* of the centre of mass before the blade, m */
} chaplygin_sleigh;

double chaplygin_sleigh_lagrangian(const double *q, const double *qd, const chaplygin_sleigh *p);

/* Velocity of the blade across itself, m/s. */
double chaplygin_sleigh_slip(const double *q, const double *qd);

#endif
