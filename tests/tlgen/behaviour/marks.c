/* Roles by marks in the source, parameters under the user's own names, an array of non-const coordinates, a result through out. */
#include <math.h>
#include "taylor/tlgen.h"

typedef struct { double k; int links; } options_t;
static const options_t params = {1.5, 2};

TLGEN(lagrangian) void action(TLGEN(out) double *value, TLGEN(p) const options_t *setup, TLGEN(qd) double v[2], TLGEN(q) double x[2])
{
  value[0] = 0.5 * setup->k * (v[0] * v[0] + v[1] * v[1]) - cos(x[0]) * x[1];
}

TLGEN(holonomic:links) void loop(TLGEN(q) double *x, TLGEN(p) const options_t *setup, TLGEN(t) double when, TLGEN(out) double *value)
{
  for (int i = 0; i < setup->links; i++) value[i] = x[i] * x[1 - i] - when;
}

TLGEN(force) void push(double *restrict qd, double *restrict out) { out[0] = -qd[0], out[1] = -2.0 * qd[1]; }
