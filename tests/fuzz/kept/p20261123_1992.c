/* What a loop carries changes by a sum whose terms are all negative. */
/* tlgen: --dof 3 --lagrangian lagrangian */
/* motion:  */
/* params:  */
#include <math.h>


static double lagrangian(const double *qd, const double *q, double t)
{
  double L = 0.0;
  int k1 = 2;
  int k2 = 4;
  while (k2 > 0) {
    int k3 = 3;
    do {
      if (qd[2] < 1.5) {
        double x4 = 1.5 - t * qd[2] * q[3 - 1 - k1];
        t += 0.4 * x4 * t;
      } else {
      }
    } while (--k3 > 0);
    for (int k = 0; k < 3; k++) {
      t = hypot(t, 1.5) * qd[k1];
    }
    k2--;
  }
  k1--;
  L += 0.5 * qd[1] * qd[1] * cos(qd[0] + t);
  return L;
}
