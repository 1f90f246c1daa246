/* Numbers wider than double on the way of values that depend on q. */
#include <math.h>
typedef long double real;
struct wide { real x; };
static const long double third = 1.0L / 3.0L;
static real argument(real x) { return 2 * x; } /* expect: long-double */
static double literal(double x) { return x * 1.5L; } /* expect: long-double */
static double cast(double x, double y) { return (double)((long double)x * y); } /* expect: long-double */
static double constant(double x) { return x * (double)third; } /* expect: long-double */
static double table(double x)
{
  static const long double k[2] = {1.0L, 2.0L}; /* expect: long-double */
  return x * (double)k[1];                      /* expect: long-double */
}
static double member(double x)
{
  struct wide w = {x}; /* expect: long-double */
  return (double)w.x;  /* expect: long-double */
}
static double through(const real *x) { return (double)*x; } /* expect: long-double */
static double root(double x) { return (double)sqrtl(x); } /* expect: long-double unknown-function */
static double accumulated(const double *q)
{
  long double s = 0.0L; /* expect: long-double */
  for (int i = 0; i < 1; i++) s += q[i]; /* expect: long-double */
  return (double)s; /* expect: long-double */
}
static double quad(double x)
{
  __float128 y = x; /* expect: type */
  return (double)y;
}
double L(const double *q)
{
  real y = q[0]; /* expect: long-double */
  return (double)argument(q[0]) + literal(q[0]) + cast(q[0], 1.0) + /* expect: long-double */
         constant(q[0]) + table(q[0]) + member(q[0]) + through(&y) + root(q[0]) + accumulated(q) + quad(q[0]); /* expect: long-double */
}
