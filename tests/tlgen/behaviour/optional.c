/* Pointers that may be NULL: optional results and arguments, lists that end with NULL, a first value of none. */
#include <math.h>
#include <stddef.h>

struct link { double length; const struct link *next; };
static const struct link third = {0.25, NULL}, second = {0.5, &third}, first = {1.0, &second};
static const struct link *const starts[2] = {&first, &second};

static double polar(double x, double y, double *angle)
{
  if (angle) *angle = atan2(y, x + 3.0);
  return sqrt(x * x + y * y + 1.0);
}

static double weighted(const double *x, const double *weights, int n)
{
  double s = 0.0;
  for (int i = 0; i < n; i++) s += x[i] * (weights == NULL ? 0.5 : weights[i]);
  return s;
}

static double reach(const struct link *chain, double angle)
{
  double x = 0.0;
  for (const struct link *l = chain; l != NULL; l = l->next) x += l->length * cos(angle * l->length);
  return x;
}

static double nearest(const double *x, int n, double to)
{
  const double *best = NULL;
  for (int i = 0; i < n; i++)
    if (!best || (x[i] - to) * (x[i] - to) < (*best - to) * (*best - to)) best = &x[i];
  return best ? *best * *best : 0.0;
}

double lagrangian(const double *q, const double *qd, double t)
{
  double angle, own[2] = {q[1], t}, *where = 0;
  double s = polar(q[0], qd[0], &angle) * angle + polar(q[1], t, NULL) + polar(1.0, 2.0, NULL);
  if (where == 0) where = own;
  where[1] *= q[0];
  s += weighted(q, own, 2) + weighted(qd, NULL, 2) + weighted(q, q[0] > 0.0 ? qd : NULL, 2);
  return s + reach(starts[0], q[0]) * reach(starts[1], q[1]) + reach(NULL, q[0]) + nearest(q, 2, 0.25) + own[1];
}
