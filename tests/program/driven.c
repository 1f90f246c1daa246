/* A pendulum whose pivot goes up and down. */
#include <math.h>
double lagrangian(const double *q, const double *qd, double t) {
  const double rate = 2.0 * cos(5.0 * t); /* of the pivot, m/s */
  const double vx = cos(q[0]) * qd[0], vy = sin(q[0]) * qd[0] + rate;
  return 0.5 * (vx * vx + vy * vy) + 9.81 * cos(q[0]);
}
