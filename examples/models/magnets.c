/* Lagrangian and drag of the magnetic pendulum, from a table of magnets. */
#include "magnets.h"

#include <math.h>

static const double mass = 1.0;      /* kg */
static const double stiffness = 0.5; /* of the string's pull to the centre, N/m */
static const double height = 0.3;    /* of the bob above the magnets, m */
static const double drag = 0.1;      /* N s/m */

static const struct magnet {
  double x, y;     /* m */
  double strength; /* J m */
} magnets[] = {
    {1.0, 0.0, 1.0},
    {-0.5, 0.8660254037844386, 1.0},
    {-0.5, -0.8660254037844386, 1.0},
};

enum { MAGNETS = sizeof magnets / sizeof magnets[0] };

double magnets_lagrangian(const double q[2], const double qd[2]) {
  double V = 0.5 * stiffness * (q[0] * q[0] + q[1] * q[1]);
  int i = 0;

  do {
    double dx = q[0] - magnets[i].x, dy = q[1] - magnets[i].y;
    V -= magnets[i].strength / sqrt(dx * dx + dy * dy + height * height);
  } while (++i < MAGNETS);
  return 0.5 * mass * (qd[0] * qd[0] + qd[1] * qd[1]) - V;
}

void magnets_drag(const double q[2], const double qd[2], double out[2]) {
  (void)q;
  for (int i = 0; i < 2; i++) out[i] = -drag * qd[i];
}
