/* Variables that only known conditions would give a value, and results read by helpers. */
/* tlgen: --lagrangian L --dof 2 --holonomic phi:2 */
struct inner { double x[2]; };
struct outer { struct inner in[2]; double m; };
static void add(double *to, const double *v, int n)
{
  while (n--) *to++ += *v++;
}
void phi(const double *q, double *out)
{
  out[0] = 0.0;
  add(out, q, 2); /* expect: uninitialized */
}
static double never(double x)
{
  double y;
  for (int i = 3; i < 3; i++) y = x;
  return y * x; /* expect: uninitialized */
}
static double selected(double x)
{
  double y;
  int kind = 3;
  switch (kind) {
  case 1: y = x; break;
  case 2: y = 2.0;
  }
  return y * x; /* expect: uninitialized */
}
static double behind(double x)
{
  double y, *p = &y, **pp = &p;
  **pp += x; /* expect: uninitialized */
  return y;
}
static double nested(double x)
{
  struct outer o, copy;
  o.in[1].x[0] = o.m = x;
  copy = o;
  return copy.in[1].x[0] + copy.in[1].x[1]; /* expect: uninitialized */
}
static double sometime(const double *q, int n)
{
  double y[2], z = 1.0;
  for (int i = 0; i < n; i++)
    if (q[i] > 0) z *= y[i]; /* expect: uninitialized */
  return z;
}
double L(const double *q) { return never(q[0]) + selected(q[1]) + behind(q[0]) + nested(q[0]) + sometime(q, 2); }
