/* Time in the open: in loops, helpers, conditions, changed as a parameter, and alone. */
#include <math.h>

struct drive { double amplitude, rate; int harmonics; };
static const struct drive params = {0.5, 3.0, 3};

static double support(double t, const struct drive *p)
{
  double y = 0.0;
  for (int k = 1; k <= p->harmonics; k++) y += p->amplitude / k * cos(k * p->rate * t);
  t = y;
  return t;
}

double lagrangian(double t, const struct drive *p, const double *qd, const double *q)
{
  double now = t, y;
  t *= 0.5;
  y = support(t, p) + support(now, p);
  if (now > 0.25) y += (now - 0.25) * (now - 0.25) * q[0];
  while (t < 1.0) t += 0.75;
  return 0.5 * qd[0] * qd[0] + y * qd[0] * sin(q[0]) + t * now - y * y;
}

void drag(const double *qd, double t, double *out)
{
  out[0] = -(1.0 + 0.5 * sin(t)) * qd[0] * fabs(qd[0]);
}

double ahead(const double *q, double t) { return q[0] - sin(2.0 * t); }
