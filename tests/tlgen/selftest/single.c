/* Single precision that depends on the coordinates, and in the parameters. */
#include <math.h>

struct filter { float gain; float table[3]; };

double lagrangian(const double *q, const double *qd, const struct filter *p)
{
  float x = q[0], s = p->gain;
  for (int i = 0; i < 3; i++) s = s * x + p->table[i];
  return s * qd[0] * qd[1] + sinf(x * 0.3f);
}
