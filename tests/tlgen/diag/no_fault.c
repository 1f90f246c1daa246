/* Nothing here is read too early, and nobody leaves an array: a force's results begin at zero, a copy may be made before all is there. */
/* tlgen: --lagrangian L --dof 2 --force F */
#include <string.h>
struct part { double m, x[2]; };
static void damp(int i, double qd, double *out) { out[i] -= 0.5 * qd; }
void F(const double *qd, double *out)
{
  for (int i = 0; i < 2; i++) damp(i, qd[i], out);
  out[1] += qd[0];
}
static double copies(const double *q)
{
  struct part one, two;
  double v[3], w[3], unused;
  one.m = q[0];
  two = one;
  two.x[0] = q[1];
  v[0] = v[1] = q[0];
  memcpy(w, v, sizeof v);
  (void)unused;
  return two.m * two.x[0] + w[1];
}
static double guarded(const double *q, int n) { return n > 2 ? q[2] : q[n - 1]; }
static double neighbours(const double *q)
{
  const double *p = q - 1, *end = q + 2;
  double s = 0.0;
  while (++p != end) s += *p;
  return s;
}
static double past(const double *q, double t)
{
  double now = t, before[2], s = 0.0;
  for (int i = 0; i < 3; i++) {
    if (now > t) s += before[i - 1]; /* notes: adjoint-unsuitable */
    if (i < 2) before[i] = q[i];
    now += 0.5;
  }
  return s;
}
double L(const double *q, const double *qd, double t)
{
  return qd[0] * qd[1] + copies(q) + guarded(q, 2) + neighbours(q) + past(q, t);
}
