/* Pointer walks: ++ and -- on both sides, offsets of both signs, differences, comparisons, chosen pointers, steps over structs. */
#include <math.h>
#include <stddef.h>

struct item { double a, b; };

static double walk(const double *p, const double *end, const double *w)
{
  double s = 0.0;
  while (p < end) s += *p++ * *w++;
  return s;
}

static double backward(const double *p, ptrdiff_t n)
{
  double s = 0.0;
  for (p += n; n > 0; n--) {
    s = 0.5 * s + *--p;
    s += p[0] * (n - 1);
  }
  return s;
}

static double total(const struct item *i, const struct item *end)
{
  double s = 0.0;
  while (i != end) {
    struct item one = *i++;
    s += one.a * one.b;
  }
  return s;
}

double lagrangian(const double *q, const double *qd, double t)
{
  static const double weight[3] = {0.5, 1.0, 1.5};
  double work[5] = {t, q[0], q[1], q[2], 0.25}, *w = work, *middle = &work[2], L = 0.0;
  struct item items[3], *i = items;
  const double *chosen = q[0] > 0.0 ? q : qd, *last = q + 3;

  L += walk(q, q + 3, weight) + walk(qd, qd + 2, q + 1) + backward(q, 3) + backward(weight, 2) * t;
  L += chosen[1] * *(chosen + 2) + last[-1] * *(last - 2);
  *w++ *= 2.0;
  *w++ += 0.5;
  w[-1] = *middle * middle[-1] + middle[1];
  *++w = t * t;
  --w;
  L += *w + (w - work) * work[1] + (double)(middle - w) * t + (&work[4] - work) + *(work + 3);
  for (double *p = work, *e = work + 5; p < e; p += 2) L += *p * (p - work + 1);
  for (int k = 0; k < 3; k++, i++) {
    i->a = q[k] * qd[k];
    (*i).b = t + k;
  }
  for (const struct item *c = items; c < items + 3 && items + 3 > c; c++) L += c->a * c->a;
  L += total(items, i) + total(items + 1, &items[2]) + (i > items ? i[-1].a : 0.0);
  i -= 2;
  *i-- = items[2];
  *i++ = items[1];
  L += items[0].a * items[1].b + (i - items);
  middle -= 1;
  L += *middle--;
  L -= *middle;
  i = items;
  (*i++).a = (w = work, *w++ = q[1] * t);
  L += i[-1].a + i->b;
  L += (*w)++ * (i++)->a;
  L += w[0] * i->b;
  L += *--w < 0.5 ? 1.0 : t;
  return L;
}
