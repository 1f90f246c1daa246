/* So steep that the truncation error of differences shows. */
/* tlgen: --dof n --lagrangian lagrangian */
/* motion: --size n=3 --parameter rest */
/* params: n=3 rest=-1.0,-0.35,0.5,0.17 */
#include <math.h>

struct params { int n; double rest[4]; };

static double lagrangian(const double *q, const double *qd, const struct params *p)
{
  double L = 0.0;
  for (int i = 0; i < p->n; i++) L += 8.0 * qd[i] * qd[i];
  double angle3 = 0.0, x1 = 0.0, y2 = 0.0;
  for (int i = 0; i < p->n; i++) {
    angle3 = q[i];
    x1 += qd[i] * cos(angle3);
    y2 -= qd[i] * sin(angle3);
    L += 0.5 * 0.7 * (x1 * x1 + y2 * y2);
  }
  L /= 1.5 + 0.5 * sin(cos(p->rest[0]) - copysign(1.0 + L * L, qd[1] - 0.31)) * acos(0.7 * cos(L)) * 0.5 * sin(cos(p->rest[0]) - copysign(1.0 + L * L, qd[1] - 0.31)) * acos(0.7 * cos(L));
  double x4 = L;
  L += 0.4 * x4 * 0.5 * log10(3.0 + sin(x4) * sin(x4));
  return L;
}
