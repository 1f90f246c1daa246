/* Compound literals: as arguments by value and by pointer, written to, of constants, of jets and of both, in conditions and loops. */
#include <math.h>

struct vec { double x, y; };

static double dot(const double *a, const double *b, int n)
{
  double s = 0.0;
  while (n-- > 0) s += a[n] * b[n];
  return s;
}
static double norm(const struct vec *v) { return v->x * v->x + v->y * v->y; }
static double moved(struct vec *v, double by)
{
  v->x += by;
  return v->x * v->y;
}
static double sum(struct vec v) { return v.x + v.y; }
static double grown(double *a) { return a[0] = a[0] * a[1]; }

double lagrangian(const double *q, const double *qd, double t)
{
  double L = dot(q, (double[]){1.0, 2.0}, 2) + dot((double[]){q[0], 0.5, t}, (double[3]){1.0, 2.0, 3.0}, 3) + dot((double[2]){[1] = t}, qd, 2);
  struct vec *p = &(struct vec){q[0], qd[1]}, v = (struct vec){.y = t};

  L += norm(&(struct vec){q[0], qd[0]}) + norm(&(struct vec){1.0, 2.0}) * t + moved(&(struct vec){1.0, 2.0}, t) + moved(p, q[1]) + p->x;
  for (int i = 0; i < 2; i++) L += sum((struct vec){q[i], i}) * norm(p) + grown((double[]){q[i], t + i});
  if (q[0] > 0.0 && norm(&(struct vec){q[0], t}) > 0.25) L += v.y;
  L += q[1] > 0.0 ? dot((double[]){q[1], 1.0}, q, 2) : (double){t} * 2.0;
  v = *&(struct vec){v.y, q[1]};
  return L + v.x * v.y + ((struct vec){t, 2.0}).x + (double[]){1.0, q[0]}[1];
}
