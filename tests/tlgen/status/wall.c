/* The other file of well.c. */
#include "wall.h"

#include <math.h>

double wall(double x)
{
  double y = x + 1.0;

  y *= sqrt(x);
  return y;
}
