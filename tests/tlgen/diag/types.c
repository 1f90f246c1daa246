/* Types that hide values, or have no jets. */
#include <complex.h>
union bits { double x; long n; };
struct flags { unsigned on : 1; };
double L(const double *q, const double *qd)
{
  volatile double a = q[0];        /* expect: volatile */
  _Atomic int b = 1;               /* expect: atomic unsupported */
  union bits c;                    /* expect: union */
  double complex d = 1.0;          /* expect: complex unsupported */
  long double e = q[0];            /* expect: long-double */
  int n = 3;
  struct flags g = {1};            /* expect: type */
  void *h;                         /* expect: type */
  float k = q[0];
  (void)h;
  return a + n + g.on + k + e;     /* expect: long-double */
}
