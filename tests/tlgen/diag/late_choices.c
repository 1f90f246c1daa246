/* Functions chosen by what has changed before they are called. */
#include <math.h>
static double (*const table[2])(double) = {sin, exp};
struct law { double (*f)(double); };
static const struct law laws[2] = {{sin}, {exp}};
static double kept(double x, int i)
{
  double (*const f)(double) = table[i]; /* i stays */
  return f(x);
}
static double changed(double x, int i)
{
  double (*const f)(double) = table[i];
  const struct law o = laws[i];
  i = 1;
  return f(x)     /* expect: function-pointer */
         + o.f(x); /* expect: function-pointer */
}
static double condition(double x)
{
  double (*f)(double) = x > 0.0 ? sin : exp;
  x = -1.0;
  return f(x); /* expect: function-pointer */
}
double L(const double *q) { return kept(q[0], 1) + changed(q[0], 0) + condition(q[0]); }
