/* Two names for one number. */
#include <math.h>

struct vec { double x, y; };

static double pair(double *x, const double *a)
{
  double s;
  *x = sin(a[0]);
  s = cos(a[0]);
  return s * *x;
}


static double passed(double x, double *a)
{
  a[0] = 2.0 * x;
  a[1] += a[0] + x;
  return x;
}

static void mix(struct vec *a, const struct vec *b)
{
  a->x = b->x * b->y;
  a->y = b->x + b->y;
}

static struct vec turn(struct vec a, struct vec *b)
{
  b->x = a.y;
  b->y = -a.x;
  return (struct vec){a.x + b->x, a.y + b->y};
}

double lagrangian(const double *q, const double *qd, double t)
{
  double s = q[0], c, *p = &s, *r = p, L = 0.0, a[2] = {qd[0], qd[1]};
  struct vec u = {q[1], t}, v = {qd[0], q[0]}, *w = &u;

  s = sin(p[0]);
  c = cos(p[0]);
  L += s * c;
  *r = q[1];
  s += s * *r;
  s += *p * s;
  L += s;
  r = &c;
  c += *r * *r;
  s = *r;
  c = s + *r;
  L += pair(&c, r);
  L += c;
  L += passed(a[0], a);
  L += passed(a[1], a);
  L += a[0] + a[1];
  mix(&u, &u);
  mix(w, &v);
  u = turn(u, &u);
  v = turn(*w, w);
  *w = (struct vec){w->y, w->x * u.y};
  u = *w;
  return L + u.x * v.y - u.y * v.x + s * c;
}
