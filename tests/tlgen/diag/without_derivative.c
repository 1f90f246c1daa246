/* Functions of math.h that nobody wants to differentiate. */
#include <math.h>
double L(const double *q, double t)
{
  double a = nextafter(q[0], 1.0); /* expect: unknown-function */
  return a + logb(t)               /* expect: unknown-function */
         + ilogb(q[0] * t);        /* expect: unknown-function */
}
