/* A cart on a straight track with two poles in a chain; q = (x, theta1, theta2): cart position, m; angles of the poles from the upward
 * vertical, rad. */
#ifndef DOUBLE_CART_POLE_H
#define DOUBLE_CART_POLE_H

struct double_cart_pole {
  double cart_mass;      /* kg */
  double pole_mass[2];   /* kg, uniform rods: the lower one first */
  double pole_length[2]; /* m */
  double gravity;        /* m/s^2 */
  double push;           /* horizontal force on the cart, N */
  double cart_drag;      /* viscous friction of the cart, N s/m */
  double hinge_drag[2];  /* viscous friction of each hinge, N m s/rad */
};

double double_cart_pole_lagrangian(const double q[3], const double qd[3], const struct double_cart_pole *p);

/* Generalized force out = (N, N m, N m): the push and the friction. */
void double_cart_pole_force(const double q[3], const double qd[3], const struct double_cart_pole *p, double out[3]);

#endif
