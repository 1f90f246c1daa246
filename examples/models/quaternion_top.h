/* A symmetric top on its tip in the field of gravity, attitude by a quaternion q = (w, x, y, z) of unit length from body to world; the
 * body's z axis is that of the top, the world's z points up. With four coordinates for three freedoms M is singular but for the
 * constraint. */
#ifndef QUATERNION_TOP_H
#define QUATERNION_TOP_H

typedef struct quaternion_top {
  double across, along; /* moments of inertia about the tip, across the axis and along it, kg m^2 */
  double mass, height;  /* kg; of the centre of mass above the tip on the axis, m */
  double gravity;       /* m/s^2 */
} quaternion_top;

/* The axis at rest at an angle of tilt from the vertical, rad, the top turning about it at a rate of spin, rad/s. */
void quaternion_top_start(double tilt, double spin, double *q, double *qd);

double quaternion_top_lagrangian(const double *q, const double *qd, const quaternion_top *p);

/* |q|^2 - 1. */
double quaternion_top_unit(const double *q);

/* Cosine of the angle between the axis and the vertical. */
double quaternion_top_upright(const double *q);

#endif
