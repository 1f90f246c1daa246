/* Calls that could reach any function: pointers that change, that come with the parameters, or that a struct carries along. */
#include <math.h>
struct law { double (*value)(double); };
struct p { double (*force)(double); };
static double twice(double x) { return 2.0 * x; }
static double thrice(double x) { return 3.0 * x; }
static double call(double (*f)(double), double x) { return f(x); }
static double late(double (*f)(double), double x)
{
  f = twice;   /* expect: function-pointer */
  return f(x); /* expect: function-pointer */
}
static double carried(struct law l, double x) { return l.value(x); } /* expect: function-pointer */
static double (*const gaps[3])(double) = {twice, [2] = thrice};
static double raised(double x, int *n) { return ((*n)++ ? twice : thrice)(x); } /* expect: function-pointer */
double L(const double *q, const struct p *p)
{
  double (*f)(double) = twice, (*g)(double) = thrice;
  struct law l = {twice};
  int n = 0;
  if (q[0] > 0.0) g = f;         /* expect: function-pointer */
  return f(q[0]) + call(sin, q[0]) + raised(q[0], &n) +
         g(q[0]) +               /* expect: function-pointer */
         call(g, q[0]) +         /* expect: function-pointer */
         l.value(q[0]) +         /* expect: function-pointer */
         carried(l, q[0]) + late(twice, q[0]) +
         gaps[q[0] > 0.0](q[0]) + /* expect: function-pointer */
         p->force(q[0]);         /* expect: function-pointer */
}
