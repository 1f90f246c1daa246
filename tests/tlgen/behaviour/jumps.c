/* switch with fall-through and blocks, goto out of loops and past declarations. */
#include <math.h>

enum { SOFT, HARD, STOP, OTHER };

static double spring(int kind, double x) {
  double force = 0, e;
  switch (kind) {
  case SOFT: return 0.5 * x * x;
  case HARD: force = x * x; /* and then as STOP */
  case STOP: {
    double wall = exp(x);
    force += wall;
    break;
  }
  default:
    e = sin(x);
    force = e * e;
  }
  return force;
}

static double first_above(const double *x, int n, double limit) {
  double s = 0;
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < 2; k++)
      if (x[i] * (k + 1) > limit) goto found;
    s += x[i] * x[i];
  }
  s *= 2;
  goto done;
found:
  s = s * x[0] + 1;
done:;
  double twice = s + s;
  return twice;
}

/* A block's own name for what a parameter is called too. */
static double shadowed(double x, double y)
{
  double s = y;
  if (y > 10.0) goto out;
  {
    double x = y * y;
    s += x * x;
  }
out:
  return s * x;
}

double lagrangian(const double *q, const double *qd) {
  double s = 0;
  for (int kind = SOFT; kind <= OTHER; kind++) {
    switch (kind) {
    case 1: continue;
    case 3: s -= spring(kind, q[0]);
    }
    s += spring(kind, q[kind % 2] + 0.1 * kind) * qd[1];
  }
  return s + first_above(q, 2, 0.4) + first_above(qd, 2, -3.0) + spring(HARD, qd[0]) + shadowed(q[0], qd[1]);
}
