/* A logarithm of its own and one in another file, on lines that test_status.c knows. */
#include "wall.h"

#include <math.h>

double lagrangian(const double *q, const double *qd)
{
  double outer = wall(q[0]) + log(q[1]);
  return qd[0] * qd[0] + outer;
}
