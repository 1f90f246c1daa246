/* Large numbers cancel, so that double keeps few digits. */
/* tlgen: --dof 4 --lagrangian lagrangian */
/* motion:  */
/* params:  */
#include <math.h>

static double lagrangian(double t, const double *qd, const double *q)
{
  double L = 0.0;
  for (int i = 0; i < 4; i++) L += 4.0 * qd[i] * qd[i];
  t /= 1.5 + qd[2] * 1.5;
  for (int i = 0; i < 4; i++) {
    double x1 = L;
    L += L * x1;
  }
  L += t - L;
  return L;
}
