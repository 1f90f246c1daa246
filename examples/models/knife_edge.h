/* A blade that glides on an inclined plane and may not slip sideways; q = (x, y, heading), m, m, rad; x points uphill. */
#ifndef KNIFE_EDGE_H
#define KNIFE_EDGE_H

struct knife_edge {
  double mass;    /* kg */
  double inertia; /* about the contact point, kg m^2 */
  double gravity; /* m/s^2 */
  double slope;   /* of the plane, rad */
};

double knife_edge_lagrangian(const double *q, const double *qd, const struct knife_edge *p);

/* Velocity across the blade, m/s; zero where it does not slip. */
double knife_edge_slip(const double *q, const double *qd);

#endif
