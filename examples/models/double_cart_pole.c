/* Lagrangian and force of the cart with two poles in a chain. */
#include "double_cart_pole.h"
#include <math.h>

double double_cart_pole_lagrangian(const double q[3], const double qd[3], const struct double_cart_pole *p) {
  double vx = qd[0], vy = 0, height = 0; /* of the hinge below the pole */
  double kinetic = p->cart_mass * vx * vx / 2, potential = 0;

  for (int i = 0; i < 2; i++) {
    const double m = p->pole_mass[i], l = p->pole_length[i], rate = qd[i + 1];
    const double ux = l * rate * cos(q[i + 1]), uy = -l * rate * sin(q[i + 1]), up = l * cos(q[i + 1]);
    const double cx = vx + ux / 2, cy = vy + uy / 2; /* of the pole's centre */
    kinetic += m * (cx * cx + cy * cy) / 2 + m * l * l / 12 * rate * rate / 2;
    potential += m * p->gravity * (height + up / 2);
    vx += ux;
    vy += uy;
    height += up;
  }
  return kinetic - potential;
}

void double_cart_pole_force(const double q[3], const double qd[3], const struct double_cart_pole *p, double out[3]) {
  const double lower = p->hinge_drag[0] * qd[1], upper = p->hinge_drag[1] * (qd[2] - qd[1]); /* torques of the hinges */
  (void)q;
  out[0] = p->push - p->cart_drag * qd[0];
  out[1] = upper - lower;
  out[2] = -upper;
}
