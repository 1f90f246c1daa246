/* Variables that have no value where a condition decides otherwise, and are read for sure. */
static double branch(double x)
{
  double y;
  if (x > 0) y = x; /* expect: uninitialized */
  return y;
}
static double both(double x, double z)
{
  double y;
  if (x > 0 && z > 0) y = x; /* expect: uninitialized */
  return y;
}
double L(const double *q) { return branch(q[0]) + both(q[0], q[0]); }
