#include <math.h>
static double twice(double x) { return 2.0 * x; }
static double call(double (*f)(double), double x) { return f(x); } /* expect: function-pointer */
double L(const double *q)
{
  double (*f)(double) = twice; /* expect: function-pointer */
  return f(q[0]) +             /* expect: function-pointer */
         call(sin, q[0]);      /* expect: function-pointer */
}
