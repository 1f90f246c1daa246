/* Programs that look as if they read too early or too far, and do not. */
#include <math.h>
#include <string.h>

struct flags { int dim, spin, order[3]; double k; };
static const struct flags params = {2, 0, {1, 0, 1}, 0.5};

struct part { double m, x[2]; };

/* Fortran's arrays from 1. */
static double from_one(const double *q, const double *qd)
{
  double s = 0.0;
  --q;
  --qd;
  for (int i = 1; i <= 2; ++i) s += q[i] * qd[i];
  return s;
}

/* A third coordinate that the caller does not have. */
static double length(const double *x, int dim)
{
  double s = x[0] * x[0] + x[1] * x[1];
  if (dim > 2) s += x[2] * x[2];
  return s;
}

/* A result that only one of the answers gives. */
static int invert(const double *x, double *result)
{
  if (x[0] * x[0] < 1e-30) return 1;
  *result = 1.0 / (2.0 + x[0]);
  return 0;
}

/* The value of the round before. */
static double differences(const double *x, int n)
{
  double last, s = 0.0;
  int have = 0;
  for (int i = 0; i < n; i++) {
    if (have) s += (x[i] - last) * (x[i] - last);
    last = x[i];
    have = 1;
  }
  for (int i = 0; i < n; i++) {
    double now = x[i] * 0.5;
    if (i > 0) s += now * last;
    last = now;
  }
  return s;
}

/* Neighbours in a ring, counted down without a sign, two buffers that change places. */
static double diffuse(const double *x, double k)
{
  double a[5], b[5], *now = a, *next = b;
  for (unsigned i = 5; i-- > 0;) now[i] = i < 2 ? x[i] : 0.1 * i;
  for (int step = 0; step < 3; step++) {
    for (int i = 0; i < 5; i++) next[i] = now[i] + k * (now[(i + 1) % 5] - 2.0 * now[i] + now[(i + 4) % 5]);
    double *swap = now;
    now = next;
    next = swap;
  }
  return now[0] * now[3];
}

/* A stack, and the end of an array as a place to stop at. */
static double stack(const double *x)
{
  double keep[4];
  int top = 0;
  const double *end = x + 2;
  for (const double *p = x; p < end; p++) keep[top++] = *p * *p;
  for (const double *p = x; p != end; ++p) keep[top++] = *p;
  double s = 0.0;
  while (top > 0) s = s * 0.5 + keep[--top];
  return s;
}

/* Rows one after the other, and a table longer than anybody runs round by round. */
static double flat(const double *x)
{
  double m[2][3], table[500], *p = &m[0][0], s = 0.0;
  for (int i = 0; i < 6; i++) p[i] = x[i % 2] + i;
  for (int i = 0; i < 500; i++) table[i] = x[1] * i;
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 3; j++) s += m[i][j] * table[100 * i + j];
  return s + table[499] * 1e-3;
}

/* The first part of an array, copied before all of it is there; words that say which of two is meant. */
static double copied(const double *x, const struct flags *p)
{
  struct part one, two, list[2];
  double v[3], w[3], *which = p->dim > 2 ? v : w;
  one.m = x[0];
  one.x[1] = one.x[0] = x[1];
  two = one;
  two.x[0] = 2.0;
  list[0] = two;
  v[0] = v[1] = x[0];
  memcpy(w, v, 2 * sizeof *v);
  which[2] = x[1];
  for (int i = 0; i < 2; i++) list[1].x[p->order[i]] = x[i];
  list[1].m = 1.0;
  (void)v[2];
  return list[0].m * list[0].x[1] + two.x[0] * w[2] + list[1].x[0] * list[1].x[1];
}

/* Kinds, each with what it needs; jumps over what is not needed. */
static double kinds(int kind, double x)
{
  double a, b;
  switch (kind) {
  case 0: a = x; b = 1.0; break;
  case 1: a = 2.0; /* fall through */
  case 2: b = x * x; break;
  default: return 0.0;
  }
  if (kind == 2) goto end;
  b *= a;
end:
  return b;
}

/* As long as it takes. */
static double root(double x)
{
  double y = 1.0 + 0.5 * x * x, step, seen[40];
  int n = 0;
  do {
    step = (y - (2.0 + x * x) / y) / 2.0;
    y -= step;
    seen[n++] = y;
  } while (fabs(step) > 1e-40 && n < 40);
  return seen[n - 1];
}

/* A time that has passed only after the first step. */
static double late(double t, double x)
{
  double now = t, before, s = 0.0;
  for (int i = 0; i < 3; i++) {
    if (now > t) s += before * x;
    before = x + now;
    now += 0.25;
  }
  return s;
}

double lagrangian(const double *q, const double *qd, double t, const struct flags *p)
{
  double inverse, spin, s = 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) * (2.0 + q[1] * q[1]);
  if (p->spin) spin = q[0];
  if (invert(q, &inverse) == 0) s += inverse * q[1];
  if (p->spin) s += spin * length(q, 3);
  if (p->dim > 2) s += q[2];
  s += from_one(q, qd) + length(q, p->dim) + length(qd, 2) + differences(q, 2) + diffuse(q, p->k) + stack(q) + flat(q) + copied(q, p);
  for (int kind = 0; kind < 4; kind++) s += kinds(kind, q[0]);
  return s + root(q[1]) + late(t, q[0]);
}
