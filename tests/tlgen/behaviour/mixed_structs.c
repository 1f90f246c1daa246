/* Structs that hold integers beside jets: counters, sizes, flags and lists of indices, copied, passed and returned with their numbers. */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

enum shape { POINT, ROD, WHEEL };
typedef struct { double m[3][3]; int rows, cols; } matrix;
typedef struct { enum shape shape; unsigned char color; bool fixed; double x, y; size_t links[2]; unsigned long id; } body;
typedef struct { short used; double value[4]; float weight; body owner; } stack;

static matrix make(int rows, int cols, double a)
{
  matrix r = {.rows = rows, .cols = cols};
  for (int i = 0; i < r.rows; i++)
    for (int j = 0; j < r.cols; j++) r.m[i][j] = a * (i + 1) + sin(a) * j;
  return r;
}

static matrix product(const matrix *a, matrix b)
{
  matrix c = {{{0.0}}, a->rows, b.cols};
  for (int i = 0; i < c.rows; i++)
    for (int j = 0; j < c.cols; j++)
      for (int k = 0; k < a->cols; k++) c.m[i][j] += a->m[i][k] * b.m[k][j];
  return c;
}

static void push(stack *s, double x) { s->value[s->used++] = x; }
static double pop(stack *s) { return s->value[--s->used]; }

static double bodies(double x, double y)
{
  body list[3] = {{ROD, 200, true, x, y, {1, 2}, 7ul}, {.shape = WHEEL, .x = 1.0, .links = {[1] = 1}}}, b;
  double s = 0.0;
  list[2] = list[0];
  list[2].color += 100; /* wraps */
  list[2].shape = POINT;
  list[2].fixed = !list[2].fixed;
  list[1].id = list[0].id * 3 + list[1].links[1];
  list[1].id -= 2;
  b = list[list[0].links[1]];
  list[2].links[0]++;
  for (size_t i = 0; i < 3; i++) {
    body *p = &list[i];
    switch (p->shape) {
    case POINT: s += p->x * p->color; break;
    case ROD: s += p->y * (double)p->id; break;
    default: s += p->x * p->x + p->y;
    }
    if (p->fixed) s *= x + (double)p->links[0];
  }
  return s + b.x * (double)b.links[0] + (double)list[1].id * x - list[2].links[0]++ * y + (double)list[2].links[0];
}

static stack calculator(double x, double y)
{
  stack s = {0, {0.0}, 0.5f, {.shape = ROD}};
  push(&s, x);
  push(&s, y);
  push(&s, pop(&s) * pop(&s) + 1.0);
  push(&s, x + s.used);
  s.owner.x = s.value[(s.used += 1) - 2];
  s.used = (short)(s.used - 1);
  return s;
}

double lagrangian(const double *q, const double *qd, double t)
{
  matrix a = make(2, 3, q[0]), b = make(3, 2, qd[0]), c = product(&a, b), d;
  stack s = calculator(q[1], qd[1]);
  double L = 0.0;
  memcpy(&d, &c, sizeof d);
  if (d.rows == d.cols && make(d.rows, 1, t).cols == 1) L += d.m[0][1] * d.m[1][0] - d.m[1][1] * d.rows;
  while (s.used > 0) L += pop(&s) * s.weight;
  return L + s.used * q[0] + s.owner.x * (s.owner.shape == ROD) + bodies(q[0], qd[1]) + (double)sizeof(matrix) * 0.0 * t;
}
