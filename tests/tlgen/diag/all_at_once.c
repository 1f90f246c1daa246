/* Faults that different passes find are reported together. */
#include <math.h>
double outside(double x);
double L(const double *q, double unknown) /* expect: role-unknown */
{
  double x;
  int n = 0;
  n = n++ + 1;                   /* expect: unsequenced */
  return x * q[0] +              /* expect: uninitialized */
         outside(q[0]) + n;      /* expect: unknown-function */
}
