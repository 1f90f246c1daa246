/* A loop fills an array with a value from outside of it. */
/* tlgen: --dof n --lagrangian lagrangian */
/* motion: --size n=1 */
/* params: n=1 */
#include <math.h>

struct pair { double x, y; };
struct params { int n; };

static double lagrangian(const double *q, const double *qd, const struct params *p)
{
  double L = 0.0;
  for (int i = 0; i < p->n; i++) L += 15.0 * qd[i] * qd[i];
  double *z6 = &L;
  struct pair u8[4];
  for (int k = 0; k < 4; k++) {
    u8[k] = (struct pair){.y = *z6, .x = 1.5};
  }
  for (struct pair *w9 = u8; w9 < u8 + 4; w9++) L += 0.2 * w9->x * cos(w9->y);
  return L;
}
