/* Two uniform bars in a vertical plane; q = (shoulder, elbow): the first angle from the downward vertical, the second relative to
 * the first bar, rad. */
#ifndef DOUBLE_PENDULUM_H
#define DOUBLE_PENDULUM_H

typedef struct Bar {
  double mass;    /* kg */
  double length;  /* m */
  double centre;  /* from the near hinge to the centre of mass, m */
  double inertia; /* about the centre of mass, kg m^2 */
} Bar;

typedef struct DoublePendulum {
  Bar upper, lower;
  double gravity; /* m/s^2 */
} DoublePendulum;

double double_pendulum_lagrangian(const double *q, const double *qd, const DoublePendulum *p);

#endif
