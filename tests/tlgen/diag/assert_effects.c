/* An assert that does more than look. */
#include <assert.h>
double L(const double *q)
{
  double x = q[0];
  assert((x *= 2) > -1e9); /* expect: assert-effect */
  return x;
}
