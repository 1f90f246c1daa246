/* A bead on a wire that turns at a given rate, with drag: a constraint that depends on t, a force, and parameters. */
#include <math.h>

struct bead {
  double mass, gravity, drag, spin; /* kg, m/s^2, N s/m, 1/s */
};

double bead_lagrangian(const double *q, const double *qd, const struct bead *p) {
  return 0.5 * p->mass * (qd[0] * qd[0] + qd[1] * qd[1]) - p->mass * p->gravity * q[1];
}

double bead_wire(const double *q, double t, const struct bead *p) { return q[1] * cos(p->spin * t) - q[0] * sin(p->spin * t); }

void bead_drag(const double *qd, const struct bead *p, double *out) {
  for (int i = 0; i < 2; i++) out[i] = -p->drag * qd[i];
}
