/* A constant is added where the number of an iteration says so. */
/* tlgen: --dof n --lagrangian lagrangian */
/* motion: --size n=2 */
/* params: n=2 mode=1 */
#include <math.h>

struct params { int n; int mode; };

static void lagrangian(const double *q, double t, const struct params *p, const double *qd, double *out)
{
  double L = 0.0;
  switch (p->mode) {
    default: {
      for (int i = 0; i < 4; ++i) {
        int k22 = 0;
        if (k22++ >= 2) break;
        if ((1.5 < 0.9 || i % 2 == 0)) {
        } else {
          L -= 1.5;
        }
      }
    }
  }
  *out = L;
}
