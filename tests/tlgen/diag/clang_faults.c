/* What Clang warns of and would be a wrong number. */
static double no_end(double x)
{
  if (x > 0) return x;
} /* expect: syntax */
double L(const double *q)
{
  double v[2] = {0, 0};
  v[2] = q[0];                       /* expect: index-range */
  return cos(q[0]) + v[1] + no_end(q[0]); /* expect: syntax */
}
