/* Numbers and structs are passed by value: what a function does to its parameters stays there. */
#include <math.h>

struct pair { double a, b; };
struct block { struct pair p[2]; double w; };

static double half(double x)
{
  x *= 0.5;
  x += x * x;
  return x;
}

static double through_pointer(double x, double y)
{
  double *p = &x;
  *p = *p * y;
  p = &y;
  *p += 1.0;
  return x * y;
}

static double spoil(struct block s, int k)
{
  s.p[k].a *= 2.0;
  s.p[0].b = s.p[1].a;
  s.w = s.w + s.p[0].b;
  while (k-- > 0) s.w *= 1.25;
  return s.w * s.p[0].a;
}

static struct pair swapped(struct pair s)
{
  double a = s.a;
  s.a = s.b;
  s.b = a;
  return s;
}

static double keep(double x, double *y)
{
  *y = 3.0 * x; /* the caller may hand over &x */
  return x + *y;
}

static double constant_or_not(double x, double y, int n)
{
  if (n > 0) x = y;
  return x * x + n;
}

/* What its parameters become is never looked at. */
static double overwritten(double x, double y, int n)
{
  double sum = 0.0;
  y = sum = 1.5;
  for (; sum < 3.0; sum += 1.0) x += 0.5 * sum;
  n = 2;
  return sum;
}

static void accumulate(double x, int n, double *sum)
{
  while (n-- > 0) {
    *sum += x;
    x *= 0.5;
  }
}

double lagrangian(const double q[2], const double qd[2], double t)
{
  double x = q[0], y = q[1], L = 0.0;
  struct block s = {{{x, y}, {t, qd[0]}}, qd[1]};
  struct pair r;

  L += half(x) * half(half(y)) + x;
  L += through_pointer(x, y) - through_pointer(t, 2.0) + through_pointer(2.0, t) + x * y;
  L += spoil(s, 1) + spoil(s, 0) + s.p[0].a * s.p[0].b + s.w;
  r = swapped(s.p[0]);
  s.p[1] = swapped(swapped(r));
  L += r.a - 2.0 * r.b + s.p[1].a * s.p[1].a;
  L += keep(x, &x);
  L += x * keep(y, &t);
  L += t;
  y = keep(y, &y);
  L += constant_or_not(0.5, x, 1) + constant_or_not(1.5, x, 0) + constant_or_not(x, 2.0, 1);
  L *= overwritten(0.5, 2.0, 1) * overwritten(x, y, 1);
  accumulate(y, 3, &L);
  accumulate(L, 2, &L);
  t += y;
  return L + t * t;
}
