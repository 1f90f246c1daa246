/* Products of everything with everything: its second derivatives are longer than compilers like. */
/* tlgen: --lagrangian L --dof 5 */
#include <math.h>
double L(const double *q, const double *qd) { /* notes: adjoint-large */
  double x = 0;
  for (int k = 0; k < 60; k++) x = sin(x * q[k % 5] + qd[k % 5] * cos(x + k) + q[(k + 1) % 5]);
  return x;
}
