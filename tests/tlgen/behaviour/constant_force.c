/* A force without coordinates, which is constant, beside marked dissipation that returns its value. */
#include "taylor/tlgen.h"

typedef struct { double weight[2]; } constant_t;
static const constant_t params = {{0.5, -2.0}};

TLGEN(lagrangian) double energy(const double *q, const double *qd) { return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) - q[0] * q[1] * q[1]; }
TLGEN(force) void weights(const constant_t *p, double *out)
{
  for (int i = 0; i < 2; i++) out[i] = p->weight[i];
}
TLGEN(dissipation) double oil(const double *qd) { return 0.3 * qd[0] * qd[0] + 0.1 * qd[1] * qd[1] * qd[1] * qd[1]; }
