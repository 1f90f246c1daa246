/* Lagrangian and no-slip condition of a knife edge on a slope. */
#include "knife_edge.h"

#include <math.h>

enum { X, Y, HEADING };

double knife_edge_lagrangian(const double *q, const double *qd, const struct knife_edge *p) {
  double translation = p->mass * (pow(qd[X], 2) + pow(qd[Y], 2)) / 2;
  double rotation = p->inertia * pow(qd[HEADING], 2) / 2;
  double climb = q[X] * sin(p->slope);

  return translation + rotation - p->mass * p->gravity * climb;
}

double knife_edge_slip(const double *q, const double *qd) { return qd[X] * sin(q[HEADING]) - qd[Y] * cos(q[HEADING]); }
