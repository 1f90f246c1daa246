/* Loops whose number of rounds depends on the coordinates: Newton steps, Kepler's equation, halving, a series summed until it is small. */
#include <math.h>

static double kepler(double mean, double e)
{
  double E = mean, r;
  int rounds = 0;
  do {
    r = E - e * sin(E) - mean;
    E -= r / (1.0 - e * cos(E));
  } while (fabs(r) > 1e-3 && ++rounds < 20);
  return E;
}

static double root(double x)
{
  double y = 1.0;
  while (fabs(y * y - x) > 0.01 * x) y = 0.5 * (y + x / y);
  return y;
}

static double exponential(double x)
{
  double sum = 1.0, term = 1.0;
  int k = 1;
  for (;; k++) {
    term *= x / k;
    if (fabs(term) < 1e-2) return sum;
    sum += term;
  }
}

static int level(double *x)
{
  int n = 0;
  while (*x > 0.5) {
    *x *= 0.5;
    n++;
  }
  return n;
}

static double drain(double x)
{
  double s = 0.0;
  while (x-- > -0.5) s += x * x;
  do s -= 0.25 * x;
  while (++x < 0.75);
  for (double y = x; (y = y * 0.5 + 0.125) > 0.5;) s += y * x;
  return s;
}

double lagrangian(const double *q, const double *qd, double t)
{
  double x = 2.0 + q[0] + q[1], L = kepler(q[0] * 2.0, 0.3 + 0.1 * qd[0]) * qd[1] + root(1.5 + t) + root(x);
  int n = level(&x);
  double residual = 1.0, guess = t;

  do {
    residual = guess * guess * guess + guess - q[1];
    guess -= residual / (3.0 * guess * guess + 1.0);
  } while (residual > 0.05 || residual < -0.05);
  return L + n * x + exponential(q[0]) * t + guess * qd[0] + drain(q[1]) + drain(2.0 * t);
}
