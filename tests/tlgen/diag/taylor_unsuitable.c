/* Where a function without a recurrence stands in the equations, there are no coefficients in time. */
/* tlgen: --lagrangian L --dof 1 --need simulate,taylor */
#include <math.h>
double L(const double *q, const double *qd) {
  return 0.5 * qd[0] * qd[0] * atan2(q[0], 2.0); /* notes: taylor-unsuitable */
}
