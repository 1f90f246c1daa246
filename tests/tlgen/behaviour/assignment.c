/* Assignments: compound, chained, inside expressions, ++ and -- before and after, commas; on values that depend on q and on those that do not. */
#include <math.h>

double lagrangian(const double q[2], const double qd[2], double t)
{
  double a = q[0], b = q[1], c, k = 2.0, L = 0.0;
  int n = 3, m;

  a += b;
  a -= t * 0.5;
  a *= 1.0 + qd[0];
  a /= 3.0 + b * b;
  a += 2;
  a -= k;
  a *= k + 1;
  a /= k;
  k += 0.5;
  k *= n--;
  m = n++;
  m += --n;
  L += k * a + m * b;

  c = b = a * t;
  L += c++ * b;
  L += ++c * b;
  L -= b-- - --c;
  L += (c *= 0.5) * a;
  L += (a = b + 1, a * a) * qd[1];
  a++, --b;
  L += a - b * qd[0];
  L += -(a = t * b) + +c;

  b = (n = 2, n * q[0]);
  L -= n * b * qd[1];
  L += 2.0 * b * c;
  L -= b * c * k;
  L += b * b;
  L += L * 0.25;
  L -= L * b;
  L *= L;
  c = 0.5;
  c = t - c;
  b -= b * b;
  a = a;
  a *= a;
  a -= a * 2.0 - a;
  a /= 1.5 + a * a;
  c = 1.0 / (2.0 + c * c) - 1 / 4 + n / 4 * b;
  return L - a * c + b;
}
