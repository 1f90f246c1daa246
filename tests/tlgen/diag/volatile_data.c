/* volatile in every place where it can stand. */
struct sensor { volatile double x; };
typedef volatile double moving;
static double param(volatile double x) { return x; } /* expect: volatile */
static double pointer(const volatile double *x) { return *x; } /* expect: volatile */
static double array(double x)
{
  volatile double a[2] = {x, 1.0}; /* expect: volatile */
  return a[0];
}
static double member(double x)
{
  struct sensor s = {x}; /* expect: volatile */
  return s.x; /* expect: volatile */
}
static double named(double x)
{
  moving y = x; /* expect: volatile */
  return y;
}
static volatile double latest = 1.0;
static double shared(double x) { return x * latest; } /* expect: global-state */
double L(const double *q)
{
  volatile int n = 2;           /* expect: volatile */
  const volatile double *p = q; /* expect: volatile */
  return param(q[0]) + pointer(q) + array(q[0]) + member(q[0]) + named(q[0]) + shared(q[0]) + n * p[0];
}
