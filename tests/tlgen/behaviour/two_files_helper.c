/* The helper of two_files.c. */
#include <math.h>
#include "two_files.h"

static double inner_helper(double x) { return sin(x); }

double other_file(double x, const double *v, double *y)
{
  *y = v[0] * x;
  return inner_helper(x) + inside(v[0]);
}
