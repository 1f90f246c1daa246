/* The functions of rules.h and their Taylor coefficients. */
#include "rules.h"

#include "taylor/rule.h"

#include <math.h>

double rules_bump(double x) { return exp(-x * x / 2); }
double rules_saddle(double x, double y) { return sin(x) * cosh(y); }

tl_rule rules_bump_taylor;
tl_rule_n rules_saddle_taylor;

/* f' = -x f, so (k+1) f[k+1] = -x f[k] - f[k-1]. */
unsigned rules_bump_taylor(tl_real *f, tl_real x, int degree, const void *user)
{
  (void)user;
  f[0] = rules_bump(x);
  for (int k = 0; k < degree; k++) f[k + 1] = -(x * f[k] + (k > 0 ? f[k - 1] : 0)) / (k + 1);
  return TL_OK;
}

unsigned rules_saddle_taylor(tl_real *f, const tl_real *x, int degree, const void *user)
{
  (void)user;
  double circular[4] = {sin(x[0]), cos(x[0]), -sin(x[0]), -cos(x[0])}, hyperbolic[2] = {cosh(x[1]), sinh(x[1])};
  for (int i = 0; i <= degree; i++)
    for (int j = 0; i + j <= degree; j++)
      f[tl_rule_index(2, (const int[]){i, j})] = circular[i % 4] * hyperbolic[j % 2] / (tgamma(i + 1) * tgamma(j + 1));
  return TL_OK;
}
