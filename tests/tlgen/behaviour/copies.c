/* memcpy, memmove and memset of whole objects: arrays, matrices, structs, parts of them, over each other, of constants and of jets. */
#include <math.h>
#include <stddef.h>
#include <string.h>

typedef struct { double p[3], angle; } pose;

static const double identity[3][3] = {{1.0}, {0.0, 1.0}, {0.0, 0.0, 1.0}};

static void rotation(double m[3][3], double angle)
{
  memcpy(m, identity, sizeof identity);
  m[0][0] = m[1][1] = cos(angle);
  m[0][1] = -(m[1][0] = sin(angle));
}

static double trace_of_product(double a[3][3], double b[3][3])
{
  double c[3][3], s = 0.0;
  memset(c, 0, sizeof(c));
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      for (int k = 0; k < 3; k++) c[i][j] += a[i][k] * b[k][j];
  memcpy(&b[0][0], &c[0][0], 9 * sizeof(double));
  for (int i = 0; i < 3; i++) s += b[i][i] * (i + 1) + b[0][i];
  return s;
}

static double shift(double *x, int n)
{
  double s = 0.0;
  memmove(x + 1, x, (n - 1) * sizeof *x);
  for (int i = 0; i < n; i++) s += x[i] * x[i] * (i + 1);
  memmove(x, x + 1, sizeof(double) * (size_t)(n - 1));
  for (int i = 0; i < n; i++) s += x[i] * sin(x[i]);
  return s;
}

static double poses(double x, double y)
{
  pose a = {{x, y, x * y}, x - y}, b, list[2];
  memcpy(&b, &a, sizeof a);
  a.angle = 2.0;
  if (b.angle > 0.0) memset(&a, 0, sizeof(pose));
  else memset(a.p, 0, 2 * sizeof a.p[0]);
  memcpy(list, &b, sizeof(b));
  memcpy(&list[1], &a, sizeof list[1]);
  memcpy(list[1].p + 1, b.p, 2 * sizeof(double));
  return list[0].p[2] * list[1].angle + list[1].p[1] * list[0].angle + list[1].p[2] * x + a.p[0] + a.p[2];
}

static double passive(void)
{
  double a[4] = {1.0, 2.0, 3.0, 4.0}, b[4];
  int counts[3] = {1, 2, 3}, same[3];
  pose p = {{1.0, 2.0, 3.0}, 4.0}, zero;
  (void)memcpy(b, a, sizeof b);
  (void)memset(a, 0, sizeof a);
  memcpy(same, counts, sizeof same);
  memcpy(&zero, &p, sizeof zero);
  memset(&p, 0, sizeof p);
  return b[2] * same[1] + a[1] + zero.angle + p.angle;
}

/* C copies what has no value yet, too. */
static double halves(double x)
{
  pose one, two;
  double v[3], w[3];
  one.p[0] = x;
  two = one;
  two.angle = x * x;
  v[0] = v[1] = x;
  memcpy(w, v, sizeof v);
  return two.p[0] * two.angle + w[1];
}

static double variable(const double *x, int n)
{
  double a[n], b[n][2], s = 0.0;
  memcpy(a, x, sizeof a);
  memset(b, 0, sizeof b);
  memcpy(b[n - 1], x, sizeof b[0]);
  for (int i = 0; i < n; i++) s += a[i] * a[i] + b[i][0] * b[i][1];
  return s;
}

double lagrangian(const double *q, const double *qd, double t)
{
  double r[3][3], s[3][3], x[4] = {q[0], qd[0], q[1], qd[1]}, y[2];
  double flat[2][2];
  rotation(r, q[0]);
  rotation(s, q[1] * t);
  memcpy(y, q, sizeof y);
  memcpy(flat, y, sizeof flat[0]);
  memcpy(flat[1], qd, sizeof flat[1]);
  return trace_of_product(r, s) + s[0][1] * qd[0] * qd[1] + shift(x, 4) + poses(q[0], qd[1]) + poses(qd[1], q[0]) + passive() * y[1] + halves(q[1]) + variable(q, 2) * variable(qd, 2) +
         flat[0][1] * flat[1][0];
}
