/* Loops of all kinds: counted up and down, nested, endless with break, continue, two counters, bounds from the parameters. */
#include <math.h>

struct loops {
  int n, repeat;
  double mass[3];
};

static const struct loops params = {3, 4, {1.0, 0.75, 1.25}};

double lagrangian(const double *q, const double *qd, double t, const struct loops *p)
{
  double T = 0, V = 0.0;
  int i, j, k;

  for (i = 0; i < p->n; i++)
    for (j = i; j < p->n; ++j)
      T += p->mass[j] * qd[i] * qd[j] * cos(q[i] - q[j]);

  for (i = p->n - 1; i >= 0; --i) {
    if (i == 1)
      continue;
    V += sin(q[i]) * t;
  }

  i = 0;
  while (1) {
    if (i >= p->repeat)
      break;
    j = i++ % p->n;
    V = V * 0.5 + exp(-q[j] * q[j]) * qd[j];
  }

  k = p->repeat;
  do {
    T *= 1.0 + 0.01 * q[k % p->n];
    if (k == 2)
      continue;
    T += 0.1 * t * t;
  } while (--k > 0);

  for (i = 0, j = p->n - 1; i < j; i++, j--)
    V -= q[i] * q[j];

  for (;;) {
    double step = cos(V);
    V += 0.125 * step;
    if (++k >= 3)
      break;
  }

  for (double x = q[0] + 2.5, y = 1.0; x > 1.0; x -= 0.6, y *= 0.9)
    V += y * x * x * qd[1];

  for (double x = 0.0, y = t + 3.0; x < y; x += 1.0)
    for (int again = 0; again < 5; again++) {
      if (again == 1)
        continue;
      if (again == 4)
        break;
      V += 0.01 * y * q[again % 3];
    }

  for (i = 0; i < 0; i++)
    V = 0.0 / 0.0;
  for (i = 0; i < p->n; T += qd[i] * qd[i], i++)
    ;
  return T - V;
}
