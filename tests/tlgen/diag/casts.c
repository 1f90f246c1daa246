/* Casts of pointers, and what else could hide the bytes of a number. */
#include <stdint.h>
double L(const double *q)
{
  const long *bits = (const long *)q;      /* expect: pointer-cast */
  uintptr_t address = (uintptr_t)q;        /* expect: pointer-cast */
  const double *back = (double *)address;  /* expect: pointer-cast */
  return back[0] + (double)*bits;
}
