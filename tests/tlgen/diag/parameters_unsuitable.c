/* A parameter that a function without a formula for its derivative depends on: all motion functions but the one by parameters. */
/* tlgen: --lagrangian L --dof 1 --need all --parameter mass,shape */
#include <math.h>
struct spring { double mass, shape; };
double L(const double *q, const double *qd, const struct spring *p) {
  const double stiffness = tgamma(p->shape); /* notes: parameters-unsuitable */
  return 0.5 * (p->mass * qd[0] * qd[0] - stiffness * q[0] * q[0]);
}
