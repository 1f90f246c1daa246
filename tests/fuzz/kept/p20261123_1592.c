/* Iterates into a jump of fmod: in double it ends on the other side. */
/* tlgen: --dof 3 --recursion helper1:4 --lagrangian lagrangian */
/* motion: --parameter k */
/* params: k=1.65 */
#include <math.h>

struct params { double k; };

static double helper1(int level, double x)
{
  if (level == 0) return 1.5;
  for (int i = 0; i < 4; ++i) {
    x -= sin(fmod(0.5 * (0.5 * (x + x) + x) + 2.3, 1.7));
  }
  return 0.5 * 1.5 * helper1(level - 1, x) + x;
}

static double lagrangian(const double *q, const double *qd, double t, const struct params *p)
{
  double L = 0.0;
  L += helper1(3, qd[1]);
  return L;
}
