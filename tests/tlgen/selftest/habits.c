/* What a source may hold beside its model: a main, output, members and helpers with the names of functions, macros on common words. */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "habits.h"

#define q0 q[0]
#define params p
#define count 2

static double exp_of(double log) { return exp(-log * log); }

static void print(double x) { printf("%g\n", x); }

double potential(const double *q, const double *qd, double t, const tuning *params)
{
  double hypot = 0.0;
  assert(p->rows <= 3);
  for (unsigned char i = 0; i < p->rows; i++)
    for (int k = 0; k < count; k++) hypot += p->exp[i][k] * q[k] * sin(qd[k] + p->mode);
  for (int i = 0; p->more && i < p->more_count; i++) hypot += p->more[i] * q0;
  return STIFF * hypot * exp_of(q0) + (p->flag ? p->single * t : 0.0) + p->part[1].big;
}

double touch(const double *q, const tuning *params) { return q0 * q[1] - p->part[0].rest; }

int main(int argc, char **argv)
{
  print(argc > 1 ? strtod(argv[1], NULL) : DBL_MAX_HERE);
  return EXIT_SUCCESS;
}
