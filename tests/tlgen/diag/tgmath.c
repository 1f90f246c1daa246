/* The functions of tgmath.h: which one a call means is decided behind a macro. */
#include <tgmath.h>
double L(const double *q)
{
  double s = sin(q[0]); /* expect: tgmath */
  s += pow(q[0], 2);    /* expect: tgmath */
  return s;
}
