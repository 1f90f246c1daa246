/* The helper of two_files.c. */
#include <math.h>
#include "two_files.h"

const double two_files_scale = 1.5, two_files_table[2] = {0.25, 0.75};

static double inner_helper(double x) { return sin(x); }

double other_file(double x, const double *v, double *y)
{
  *y = v[0] * x;
  return inner_helper(x) + inside(v[0]);
}
