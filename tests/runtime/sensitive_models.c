/* Lagrangians of models for sensitivities, and one constraint. */
#include "sensitive_models.h"

#include <math.h>

double chain_lagrangian(const double *q, const double *qd, const chain *p) {
  const double u = p->length[0] * qd[0], v = p->length[1] * qd[1];
  const double drop = p->length[0] * cos(q[0]);
  return 0.5 * p->mass[0] * u * u + 0.5 * p->mass[1] * (u * u + v * v + 2.0 * u * v * cos(q[0] - q[1])) +
         p->gravity * (p->mass[0] * drop + p->mass[1] * (drop + p->length[1] * cos(q[1])));
}

double planet_lagrangian(const double *q, const double *qd, const planet *p) {
  return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) + p->attraction / sqrt(q[0] * q[0] + q[1] * q[1]);
}

double rod_lagrangian(const double *q, const double *qd, const rod *p) {
  return p->mass * (0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) - p->gravity * q[1]);
}

double rod_circle(const double *q, const rod *p) { return sqrt(q[0] * q[0] + q[1] * q[1]) - p->length; }
