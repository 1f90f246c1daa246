/* Every function of math.h that has a derivative. */
#include <math.h>

static double one(double x)
{
  double s = sqrt(2.0 + x) + cbrt(3.0 + x) + exp(x) + expm1(x) + exp2(x) + log(2.5 + x) + log1p(0.5 * x) + log2(3.0 + x) + log10(4.0 - x);
  s += sin(x) * cos(2.0 * x) + tan(x) + asin(0.75 * x) + acos(0.5 * x) + atan(x);
  s += sinh(x) + cosh(x) * tanh(x) + asinh(x) + acosh(2.5 + x) + atanh(0.75 * x);
  return s + erf(x) + fabs(x) * x;
}

static double two(double x, double y)
{
  double s = atan2(x, y) + hypot(x, y) + pow(2.0 + x, y) + fmin(x, y) * x + fmax(x, y) * y + fma(x, y, x) + copysign(x, y) * x;
  s += atan2(x, 0.5) + atan2(-0.5, y) + hypot(1.0, x) + hypot(y, 2) + fmin(x, 0.25) * y + fmax(0.0, y) * y;
  s += fma(2.0, x, y) + fma(x, y, 1.0) + fma(x, 3, 1) + copysign(x, -1.0) * y + copysign(2.0, y) * x;
  return s;
}

static double powers(double x, double y, int n)
{
  double s = pow(x, 2) + pow(x, 3.0) + pow(x, 1) + pow(x, 0) + pow(2.0 + x, -2) + pow(2.0 + x, 0.5) + pow(1.5 + x, -1.25);
  s += pow(x, n) + pow(2.0, y) + pow(0.5, x * y) + pow(2.0 + y, x) + pow(3 + x, n - 0.5) + pow(n, x) + pow(x, -n + 2 * n);
  s += pow(2.0 + x, 1e0) + pow(x - 3.0, 5) + pow(x - 3.0, -n);
  return s;
}

double lagrangian(const double *q, const double *qd, double t)
{
  double L = one(q[0]) + one(qd[1] * t) * q[1] + one(0.5);
  L += two(q[1], qd[0]) + two(t, q[0]) * qd[1] + two(0.25, -0.75);
  return L + powers(q[0], t, 4) * powers(qd[0], q[1], 3) + powers(0.5, 0.25, 2);
}
