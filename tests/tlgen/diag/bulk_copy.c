/* Copies that are not of whole objects of one type, or whose value is used. */
#include <string.h>
struct pair { double a, b; };
double L(const double *q, const double *qd)
{
  double x[3], y[3] = {q[0], qd[0], 1.0}, *p;
  struct pair s;
  long n;
  char bytes[24];
  memcpy(x, y, 20);              /* expect: bulk-copy */
  memcpy(&s, y, sizeof s);       /* expect: bulk-copy */
  memcpy(&n, q, sizeof n);       /* expect: bulk-copy */
  memcpy(bytes, y, sizeof y);    /* expect: bulk-copy */
  memset(x, 1, sizeof x);        /* expect: bulk-copy */
  memset(x, 0, (size_t)q[0]);    /* expect: bulk-copy */
  p = memcpy(x, y, sizeof x);    /* expect: unsupported pointer-cast */
  return x[0] + s.a + (double)n + p[0];
}
