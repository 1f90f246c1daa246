/* Steps: tables looked up by floor, trunc and lround of coordinates, saw teeth and remainders; the derivative of a step is zero. */
#include <math.h>
#include <stdlib.h>

enum { POINTS = 9 };
static const double heights[POINTS] = {0.0, 0.25, 0.125, -0.5, 0.75, 1.5, 0.5, -0.25, 0.0};
static const double grid[4][4] = {{0.0, 0.5, 0.25, 1.0}, {1.0, 0.75, 0.5, 0.0}, {0.5, 0.25, -0.5, 1.5}, {0.0, -1.0, 0.5, 0.25}};

/* cubic Hermite, periodic */
static double terrain(double x)
{
  double cell = floor(x);
  int i = (int)cell, i0 = ((i % POINTS) + POINTS) % POINTS;
  double u = x - cell, y0 = heights[i0], y1 = heights[(i0 + 1) % POINTS];
  double m0 = 0.5 * (y1 - heights[(i0 + POINTS - 1) % POINTS]), m1 = 0.5 * (heights[(i0 + 2) % POINTS] - y0);
  return y0 + u * (m0 + u * (3.0 * (y1 - y0) - 2.0 * m0 - m1 + u * (2.0 * (y0 - y1) + m0 + m1)));
}

static double bilinear(double x, double y)
{
  int i = (int)floor(x), j = (int)trunc(y);
  i = i < 0 ? 0 : i > 2 ? 2 : i;
  j = j < 0 ? 0 : j > 2 ? 2 : j;
  double u = x - i, v = y - j;
  return (1 - u) * ((1 - v) * grid[i][j] + v * grid[i][j + 1]) + u * ((1 - v) * grid[i + 1][j] + v * grid[i + 1][j + 1]);
}

static double others(double x, double y)
{
  long n = lround(3.0 * x);
  double s = (3.0 * x - n) * y + (x - ceil(x)) * (y - rint(y)) + (x - round(x)) * nearbyint(4.0 * y) + abs((int)n) * x;
  s += fmod(3.0 * x, 0.75) * y + remainder(5.0 * y, 0.75) * x + fmod(2.5, y + 3.0) + remainder(x, y + 2.5) + fdim(x, y) * x;
  if (isnan(x) || isinf(y) || signbit(x - y) || !isfinite(y)) s += x * y;
  return s + erfc(x) + tgamma(2.5 + x) + lgamma(3.0 + y) + ldexp(x * y, 3) + scalbn(x, -1) + fdim(0.25, y) + floor(0.5) * x;
}

double lagrangian(const double *q, const double *qd, double t)
{
  return terrain(7.3 * q[0] + q[1]) * qd[0] + bilinear(1.5 + 2.0 * q[1], 1.6 + t) + others(q[0], qd[1]) + terrain(qd[0] * t);
}
