/* A variable that has no value yet. */
double L(const double *q)
{
  double x, y;
  y = x * q[0]; /* expect: uninitialized */
  return y;
}
