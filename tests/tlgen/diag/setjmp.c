/* Jumps over the heads of functions. */
#include <setjmp.h>
static double guarded(double x, jmp_buf out)
{
  if (x > 0) longjmp(out, 1); /* expect: unknown-function */
  return x;
}
double L(const double *q)
{
  jmp_buf back;
  if (setjmp(back)) return 1.0; /* expect: unknown-function */
  return guarded(q[0], back);
}
