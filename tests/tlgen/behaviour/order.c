/* What must happen first: commas, && and ||, ?: and their side effects, helpers with results and effects, once and not twice. */
#include <math.h>

static double add_to(double x, double *sum)
{
  *sum += x;
  return 2.0;
}

static int tick(int *n) { return ++*n; }
static double above(double x, int n) { return x - 0.1 * n; }
static double probe(double x, double y) { return x * y; }

double lagrangian(const double *q, const double *qd, double t)
{
  double x = q[0], L = 0.0, z = 0.0, a[3] = {q[0], q[1], t};
  int k = 0, n = 0;

  if ((k = 2, above(x, k) > 0.0)) L += q[1];
  if ((k = 5, x = t, above(x, k) > -0.25)) L += x * q[1];
  if ((n++, tick(&n)) == 2 && (x += 1.0, probe(x, t) > 0.2)) L += x * n;
  if (q[0] > 0.0 || add_to(t, &z) > 1.0) L += z * q[0];
  if (q[1] > 0.0 && (add_to(q[1], &z) > 3.0 || add_to(t, &z) > 1.0)) L -= z * q[1];
  L -= k > 3 ? add_to(q[0] * q[1], &z) : 0.5;
  L -= n > 100 ? 1.0 : add_to(qd[0] * t, &z);
  L *= k < 9 && add_to(x * x, &z) > 1.0 ? 0.5 : 2.0;
  z -= 0.5 * add_to(q[0], &L);
  n = 0;
  L += a[n++] * qd[0];
  L += a[n++] * qd[1];
  a[--n] *= a[2] + 1.0;
  a[n] = a[n] * a[n] + a[0];
  L += a[1] + (n ? a[0] : a[2]);
  L += (tick(&n), a[n]);
  L += x++ > 0.75 ? x : -x;
  L += x-- > 1.0 ? t : q[1];
  k = x > 0.0 ? 3 : tick(&n);
  L += k * 0.125 * t + n * q[0];
  while (n < 6 && probe(a[0], 1.0 + tick(&n)) < 8.0) L += a[n % 3] * n;
  return L + z;
}
