/* Results through pointers: several at once, over an input, over each other, into the middle of arrays and structs. */
#include <math.h>

struct frame { double e[3]; double scale; };

static void rotate(const double *a, double angle, double *out)
{
  double s = sin(angle), c = cos(angle);
  out[0] = c * a[0] - s * a[1]; /* wrong in place, as in plain C */
  out[1] = s * a[0] + c * a[1];
}

static double sum_and_difference(double x, double y, double *sum, double *difference)
{
  *sum = x + y;
  *difference = x - y;
  return *sum * *difference;
}

static void copy(const double *from, double *to, int n)
{
  while (n--) *to++ = *from++;
}

static int normalise(struct frame *f)
{
  double norm = 0.0;
  for (int i = 0; i < 3; i++) norm += f->e[i] * f->e[i];
  f->scale = norm;
  if (norm < 0.01) return -1;
  for (int i = 0; i < 3; i++) f->e[i] /= sqrt(norm);
  return norm > 1.0;
}

static void minmax(double a, double b, double *lo, double *hi)
{
  if (a < b) {
    *lo = a;
    *hi = b;
    return;
  }
  *lo = b;
  *hi = a;
}

static void twice(double *x, double *y)
{
  *x = *x * *y;
  *y += *x;
}

void lagrangian(const double *q, const double *qd, double t, double *out)
{
  double a[3] = {q[0], q[1], t}, b[3], s, d, lo, hi;
  struct frame f = {{qd[0], qd[1]}, 1.0};

  rotate(a, t, a);
  rotate(a + 1, qd[0], b);
  rotate(q, 0.5, &b[1]);
  *out = a[0] * b[0] + a[1] * b[1] + b[2];
  *out += sum_and_difference(q[0], t, &s, &d);
  *out += sum_and_difference(s, d, &s, &s);
  *out += s * d;
  copy(a, b, 3);
  copy(b + 1, b, 2);
  copy(qd, f.e + 1, 2);
  for (int i = 0; i < 3; i++) *out += b[i] * (i + 1) * f.e[i];
  out[0] += normalise(&f) * q[1];
  out[0] += f.scale * f.e[0] + f.e[1] * f.e[2];
  minmax(q[0], qd[1], &lo, &hi);
  minmax(hi, lo, &hi, &lo);
  *out += lo * 3.0 - hi;
  twice(&a[0], &a[0]);
  twice(&lo, &hi);
  twice(out, &lo);
  *out += lo + a[0];
}
