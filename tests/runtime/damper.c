/* Two sliders with a rod between them, and what resists them twice: as Rayleigh's dissipation, and as its force by hand. Smoothed dry
 * friction of the first that grows with its place and with time, drag with the square of the second's speed. */
#include "damper.h"

#include <math.h>

double damper_lagrangian(const double *q, const double *qd, const damper *p) {
  return 0.5 * p->mass * (1 + 0.2 * cos(q[0])) * qd[0] * qd[0] + 0.5 * qd[1] * qd[1] + 0.5 * qd[2] * qd[2] - 9.81 * q[2];
}

double damper_rod(const double *q) { return q[1] * q[1] + q[2] * q[2] - q[0] * q[0]; }

double damper_loss(const double *q, const double *qd, double t, const damper *p) {
  const double speed2 = qd[1] * qd[1] + qd[2] * qd[2];
  return p->dry * (1 + q[0] * q[0] + t) * sqrt(qd[0] * qd[0] + p->creep * p->creep) + p->drag / 3 * speed2 * sqrt(speed2);
}

void damper_force(const double *q, const double *qd, double t, const damper *p, double *out) {
  const double speed = sqrt(qd[1] * qd[1] + qd[2] * qd[2]);
  out[0] = -p->dry * (1 + q[0] * q[0] + t) * qd[0] / sqrt(qd[0] * qd[0] + p->creep * p->creep);
  out[1] = -p->drag * speed * qd[1];
  out[2] = -p->drag * speed * qd[2];
}
