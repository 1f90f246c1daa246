/* The same name for different things, in blocks, loops, functions and files. */
#include <math.h>

static const double x = 0.5;
static double y(double x) { return x * 2.0; }
static double use(void) { return x; }

static double z(double y)
{
  struct local { double a, b; } s = {y, 2.0 * y};
  return s.a * s.b;
}

static double w(double y)
{
  struct local { double c, a, b; } s = {y, 3.0, y * y};
  return s.a * s.b + s.c;
}

double lagrangian(const double *q, const double *qd, double t)
{
  double L = x * q[0] + use() * t + z(q[1]) + w(t);
  double a = t;
  {
    double x = q[1], a = 3.0;
    L += x * x * a;
    for (int x = 0; x < 2; x++) {
      double a = qd[x];
      L += a * x;
      { int a = x; L += a * q[0]; }
    }
    for (double a = q[0]; a < 1.0; a += 0.75) {
      double x = a * t;
      L += x * a;
      { double a = x + 1.0; L += a * a; }
    }
    L += x - a;
  }
  if (a > 0.0) {
    double y = a;
    a = y * 2.0;
  } else {
    int y = 3;
    a = a * y;
  }
  for (int i = 0; i < 2; i++) {
    double x;
    x = i ? a : t;
    L += x;
  }
  return L + y(a) + y(1.0) + x;
}
