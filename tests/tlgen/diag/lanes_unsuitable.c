/* Where the state decides on more than values, states cannot go side by side. */
/* tlgen: --lagrangian L --dof 1 --lanes */
#include <math.h>
double L(const double *q, const double *qd) {
  static const double spring[2] = {1.0, 2.0};
  const int side = q[0] > 0;
  return 0.5 * (qd[0] * qd[0] - spring[side] * q[0] * q[0]); /* notes: lanes-unsuitable */
}
