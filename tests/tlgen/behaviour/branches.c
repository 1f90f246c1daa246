/* Decisions: if and else, nested ?:, && and || with calls behind them, conditional assignment, early returns, values as truth. */
#include <math.h>

static double ramp(double x)
{
  if (x < -0.5)
    return 0.25 * x;
  else if (x < 0.25)
    return x * x - 0.375;
  return sin(x) * (x > 0.6 ? 2.0 : 1.5);
}

static int far(double x, double y)
{
  if (x * x + y * y > 0.5)
    return 1;
  if (ramp(x) > ramp(y))
    return -1;
  return 0;
}

static double clamp(double x, double lo, double hi)
{
  return x < lo ? lo : x > hi ? hi : x;
}

double lagrangian(const double *q, const double *qd, double t)
{
  double L = 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]);
  double a = q[0] > 0.0 ? q[0] * q[1] : q[0] - q[1] > 0.1 ? exp(q[0]) : t * t;
  double b;

  if (q[0] > 0.2 && far(q[0], q[1]) && ramp(t) > -0.3)
    L += a * a * a;
  else if (q[0] < -0.4 || !far(q[1], t) || ramp(a) < clamp(t, -0.5, 0.5))
    L -= a * qd[0];
  else
    ;

  if (q[1])
    L += sin(q[1]);
  if (q[0] && (t || !q[1]))
    L += q[0] * (qd[0] ? t : 1.0);
  for (double left = 1.0; left; left -= 0.5)
    if (!t || (far(t, q[0]) && left))
      L += left * t;
  if (!(t > 0.0))
    b = t;
  else
    b = clamp(qd[0], -0.3, 0.3) * t;
  L += (b > 0.0 ? ramp(b) : far(b, t) ? ramp(t) * b : ramp(b * t));
  return L;
}
