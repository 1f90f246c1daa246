/* Variable argument lists: used, unused, and handed on. */
#include <stdarg.h>
static double unused(double x, ...) { return x * x; } /* expect: variadic */
static double last(int n, ...) /* expect: variadic */
{
  va_list list; /* expect: type */
  double x = 0.0;
  va_start(list, n); /* expect: unknown-function */
  while (n-- > 0) x = va_arg(list, double); /* expect: variadic */
  va_end(list); /* expect: unknown-function */
  return x;
}
static double handed(va_list list) { return va_arg(list, double); } /* expect: variadic */
static double outer(int n, ...) /* expect: variadic */
{
  va_list list; /* expect: type */
  va_start(list, n); /* expect: unknown-function */
  return handed(list);
}
double L(const double *q) { return unused(q[0], q[0]) + last(2, q[0], 1.0) + outer(1, q[0]); }
