/* Elements, members and what stands behind pointers, read before they have a value. */
struct pair { double a, b; };
static struct pair half_made(double x)
{
  struct pair p;
  p.a = x;
  return p;
}
static double read(const double *x) { return *x; }
static void add(double *x, double y) { *x += y; }
double L(const double *q)
{
  struct pair p;
  double v[3], w[2], m[2][2], x, y, s = 0.0;
  int n = 2;
  double k[n];
  p.a = q[0];
  s += p.a * p.b; /* expect: uninitialized */
  v[0] = q[0];
  s += v[0] * v[1];                            /* expect: uninitialized */
  for (int i = 0; i < 2; i++) s += w[i];       /* expect: uninitialized */
  m[0][0] = m[0][1] = m[1][0] = q[0];
  s += m[1][1];                                /* expect: uninitialized */
  s += read(&x);                               /* expect: uninitialized */
  add(&y, q[0]);                               /* expect: uninitialized */
  s += k[0];                                   /* expect: uninitialized */
  s += half_made(q[0]).b;                      /* expect: uninitialized */
  return s + y;
}
