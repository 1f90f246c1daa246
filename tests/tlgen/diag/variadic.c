#include <stdarg.h>
/* tlgen: --lagrangian L --dof 2 */
static double sum(int n, ...) /* expect: variadic */
{
  double s = 0.0;
  va_list list;                                      /* expect: type */
  va_start(list, n);                                 /* expect: unknown-function */
  while (n-- > 0) s += va_arg(list, double);         /* expect: variadic */
  va_end(list);                                      /* expect: unknown-function */
  return s;
}
double L(const double *q) { return sum(2, q[0], q[1]); }
