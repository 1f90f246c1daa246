/* A function without a formula for its derivative, of a parameter: all motion functions are there but the one by that parameter. */
#include <math.h>

struct gamma_spring {
  double mass, shape;
};

double gamma_spring_lagrangian(const double *q, const double *qd, const struct gamma_spring *p) {
  return 0.5 * p->mass * qd[0] * qd[0] - 0.25 * tgamma(p->shape) * pow(q[0], 4);
}
