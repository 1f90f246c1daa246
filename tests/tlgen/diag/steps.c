/* Steps of values that depend on q: accepted with a warning each. */
#include <math.h>
static const double table[4] = {0.0, 1.0, 4.0, 9.0};
double L(const double *q, const double *qd, double t)
{
  int i = (int)floor(q[0]);    /* warns: zero-derivative */
  long n = lround(qd[0] * 2.0); /* warns: zero-derivative */
  double s = ceil(t)           /* warns: zero-derivative */
             + trunc(2.5);
  return s + table[i & 3] * q[0] + (double)n;
}
