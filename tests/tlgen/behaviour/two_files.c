/* A model in two files: a helper there, and the same static names here for other things. */
#include <math.h>
#include "two_files.h"

static double inner(double x) { return x * 2.0; }

double lagrangian(const double *q, const double *qd, double t)
{
  double y = 0.0;
  double L = other_file(q[0], qd, &y) + inner(t) * inner(3.0);
  return L + y * y + inside(q[0] * t) + inside(2.0) + two_files_scale * q[0] * two_files_table[1];
}
