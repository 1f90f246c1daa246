/* Structs that hold both numbers that depend on q and others. */
struct mixed { int n; double x; };
static double value(struct mixed m) { return m.x * m.n; } /* expect: struct-active */
double L(const double *q)
{
  struct mixed m = {2, q[0]}; /* expect: struct-active */
  return value(m);
}
