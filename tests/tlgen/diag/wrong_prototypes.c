/* Names of math.h with other parameters. */
double exp2(double a, double b);
int fabs(int n);
float sqrt(float x);
double L(const double *q)
{
  double s = exp2(q[0], 2.0); /* expect: unknown-function */
  s += fabs(3);               /* expect: unknown-function */
  return s * sqrt(2.0f) * q[0]; /* expect: unknown-function */
}
