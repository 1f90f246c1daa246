/* Arrays that helpers leave, copies that are too long, and an index behind a condition on the coordinates. */
/* tlgen: --lagrangian L --dof 2 --force F */
#include <string.h>
struct row { double x[3]; };
static double sum(const double *a, int n)
{
  double s = 0.0;
  for (int i = 0; i < n; i++) s += a[i]; /* expect: index-range */
  return s;
}
static double last(const struct row *rows, int n) { return rows[n].x[0]; } /* expect: index-range */
static void shift(double *to, double x) { to[1] = x; }                     /* expect: index-range */
void F(const double *qd, double *out)
{
  for (int i = 0; i < 2; i++) shift(out + i, qd[i]);
}
static const int order[3] = {0, 1, 2};
double L(const double *q, const double *qd)
{
  struct row rows[2] = {{{q[0]}}, {{q[1]}}};
  double a[2], s = 0.0;
  memcpy(a, q, 3 * sizeof *a); /* expect: index-range */
  if (q[0] > 0) s += q[2];     /* expect: index-range */
  s += q[order[2]];            /* expect: index-range */
  for (int i = 1; i >= 0; i--) s += a[i] * a[i - 1]; /* expect: index-range */
  return s + sum(qd, 3) + sum(q, 2) + last(rows, 2) + last(rows, 1);
}
