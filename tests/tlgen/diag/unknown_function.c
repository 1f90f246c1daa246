/* Functions that are not here: no derivative is known. */
#include <math.h>
double friction(double v);
double L(const double *q, const double *qd)
{
  int n;
  double L = friction(qd[0]); /* expect: unknown-function */
  L += logb(3.0) + nextafter(1.0, 2.0) + sinf(1.0f);
  L += frexp(q[0], &n);       /* expect: unknown-function */
  return L;
}
