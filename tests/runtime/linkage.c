/* A four-bar linkage whose ground and crank together are as long as coupler and rocker: all bars come to lie on one line, where elbow
 * up and elbow down meet, and there is no symmetry between the two. q = (x, y) of the pins B and C, unit masses; plain C for tlgen. */
#include "linkage.h"

double linkage_lagrangian(const double *q, const double *qd) {
  (void)q;
  return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1] + qd[2] * qd[2] + qd[3] * qd[3]);
}

void linkage_bars(const double *q, double *out) {
  const double x = q[2] - q[0], y = q[3] - q[1], r = q[2] - LINKAGE_GROUND;
  out[0] = q[0] * q[0] + q[1] * q[1] - LINKAGE_CRANK * LINKAGE_CRANK;
  out[1] = x * x + y * y - LINKAGE_COUPLER * LINKAGE_COUPLER;
  out[2] = r * r + q[3] * q[3] - LINKAGE_ROCKER * LINKAGE_ROCKER;
}
