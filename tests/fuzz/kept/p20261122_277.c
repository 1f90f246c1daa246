/* A function adds to its parameter and never looks at it. */
/* tlgen: --dof 3 --lagrangian lagrangian --nonholonomic psi:2 */
/* motion: --parameter mass */
/* params: mass=0.53,1.65,0.55,0.72,1.1,1.25 */
#include <math.h>

struct params { double mass[6]; };

static double helper3(double x, double y, const struct params *p)
{
  for (const double *w6 = p->mass, *end = p->mass + 6; w6 < end; w6++) x += 0.5 * *w6 * 1.5;
  return y;
}

static double lagrangian(const double *q, const double *qd, double t, const struct params *p)
{
  double L = 0.0;
  return L;
}

static void psi(const double *q, const double *qd, const struct params *p, double *out)
{
  double x8 = 1.5;
  out[0] = 4.0 * qd[0] + cos(q[2] + 1.5) * helper3(x8, x8, p);
  out[1] = 4.0 * qd[1] + cos(q[1] + 1.5) * 1.5;
}
