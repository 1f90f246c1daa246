/* Lagrangian of the planar Kepler problem. */
#include "kepler.h"

#include <math.h>

double kepler_lagrangian(const double q[2], const double qd[2]) {
  return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) + 1.0 / hypot(q[0], q[1]);
}
