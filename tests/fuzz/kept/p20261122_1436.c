/* A function assigns to its parameter and never looks at it. */
/* tlgen: --dof 2 --lagrangian lagrangian --nonholonomic psi:1 */
/* motion: --parameter rest */
/* params: rest=-1.0,-0.62,0.76 */
#include <math.h>

struct params { double rest[3]; };

static double helper1(int count, const double *a, double x)
{
  double sum = 0.0;
  x = sum = 1.5;
  return sum;
}

static double lagrangian(double t, const double *q, const double *qd)
{
  double L = 0.0;
  return L;
}

static void psi(const double *q, const double *qd, const struct params *p, double *out)
{
  out[0] = 4.0 * qd[0] + sin(q[1] + 1.5) * helper1(3, p->rest, 1.5);
}
