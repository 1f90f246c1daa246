/* Pointers to functions that are settled in the source: callbacks, variables, tables and structs of functions, choices between them. */
#include <math.h>

typedef double potential(double r);
typedef struct { double strength; potential *value; double (*slope)(double r, int n); } law;
enum kind { SPRING, CUBIC, COSINE, KINDS };

static double spring(double r) { return 0.5 * r * r; }
static double cubic(double r) { return r * r * r; }
static double cosine(double r) { return cos(r); }
static double times(double r, int n) { return n * r; }
static double power(double r, int n) { return n > 1 ? r * power(r, n - 1) : r; }

static potential *const table[KINDS] = {[SPRING] = spring, [COSINE] = cosine, [CUBIC] = cubic};
static const law laws[2] = {{2.0, spring, times}, {.value = &cosine, .slope = power}};

static double simpson(double (*f)(double), double a, double b, int n)
{
  double h = (b - a) / (2 * n), s = f(a) + (*f)(b);
  for (int i = 1; i < 2 * n; i++) s += (i % 2 ? 4.0 : 2.0) * f(a + i * h);
  return s * h / 3.0;
}

static double twice(double (*f)(double), double x) { return f(f(x)); }
static double both(potential f, potential *g, double x) { return twice(f, x) - simpson(g, 0.0, x, 2); }

static void each(double *x, int n, void (*change)(double *, double), double by)
{
  for (int i = 0; i < n; i++) change(&x[i], by);
}
static void scale(double *x, double by) { *x *= by; }
static void shift(double *x, double by) { *x += by; }

static double chosen(enum kind kind, double r, int up)
{
  static double (*const local[])(double) = {sin, exp};
  const law mine = laws[1];
  potential *const last = table[COSINE], *f = spring;
  double s = table[kind](r) + (up ? cubic : cosine)(r) + last(r) + f(2.0 * r);
  for (int i = 0; i < 2; i++) s += laws[i].strength * laws[i].value(r) + laws[i].slope(r, 3);
  return s + mine.value(r) * mine.slope(r, 2) + (&spring)(r) + local[0](r) * local[1](0.1 * r);
}

double lagrangian(const double *q, const double *qd, double t)
{
  double x[2] = {q[0], qd[0]}, s = 0.0;
  each(x, 2, scale, q[1]);
  each(x, 2, shift, t);
  (t > 0.0 ? shift : scale)(x, qd[1]);
  for (int k = 0; k < KINDS; k++) s += chosen((enum kind)k, x[0], k % 2) * (k + 1);
  return s + simpson(cubic, q[0], x[1], 3) + both(cosine, cubic, qd[0]) + both(spring, cosine, t) + twice(cubic, 0.5) * q[1];
}
