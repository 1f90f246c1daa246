/* A loop leaves a value that no iteration takes over from the one before. */
/* tlgen: --dof n --lagrangian lagrangian */
/* motion: --size n=4 */
/* params: n=4 */
#include <math.h>

struct params { int n; };

static double lagrangian(const struct params *p, const double *q, double t, const double *qd)
{
  double L = 0.0;
  for (int i = p->n - 1; i >= 0; i--) {
    int k1 = 2;
    L = qd[k1];
  }
  L += L * L;
  return L;
}
