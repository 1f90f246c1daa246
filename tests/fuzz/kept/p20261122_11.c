/* Functions under a condition of run time, whose derivatives are new values inside of a loop that is kept. */
/* tlgen: --dof n --lagrangian lagrangian */
/* motion: --size n=2 */
/* params: n=2 mode=1 */
#include <math.h>

struct params { int n; int mode; };

static double lagrangian(const double *q, const double *qd, double t, const struct params *p)
{
  double L = 0.0;
  double angle4 = 0.0, x2 = 0.0, y3 = 0.0;
  for (int i = 0; i < p->n; i++) {
    if ((1.5 > 1.5 || x2 >= 1.1)) {
    } else if (L <= qd[p->n - 1 - i]) {
    } else {
      for (int j = 0; j < 2; ++j) {
        switch (p->mode) {
          default: {
            double a14[4];
            for (int k = 0; k < 4; k++) a14[k] = cos(q[(k + 3) % p->n]);
            L += 0.4 * a14[(j + 0) % 4] * 1.5;
          }
        }
      }
    }
  }
  return L;
}
