/* gcc 12 clears the columns of a product with several directions too late. */
/* tlgen: --dof n --lagrangian lagrangian --force force */
/* motion: --size n=6 */
/* params: n=6 */
#include <math.h>

struct params { int n; };

static double lagrangian(const double *q, const double *qd, double t, const struct params *p)
{
  double L = 0.0;
  int k5 = 2;
  while (k5 > 0) {
    double y7 = 1.2;
    for (int k8 = 0; k8 < 4; k8++) y7 = 0.5 * (y7 + (1.0 + 1.5 * cos(qd[k5])) / y7);
    t += 0.5 * y7;
    k5--;
  }
  t += sin(fma(1.5, 0.5, 1.5));
  L += floor(2.0 * t) * sin(q[4]);
  return L;
}

static void force(const double *q, const struct params *p, double *out, const double *qd)
{
  for (int i = 0; i < p->n; i++) out[i] = -q[p->n - 1 - i];
}
