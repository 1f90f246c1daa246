#include <math.h>
double friction(double v);
double L(const double *q, const double *qd)
{
  double L = friction(qd[0]); /* expect: unknown-function */
  L += floor(q[0]);           /* expect: unknown-function */
  L += fmod(q[0], 2.0);       /* expect: unknown-function */
  return L + sinf(1.0f);      /* expect: unknown-function */
}
