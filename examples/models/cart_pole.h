/* A cart on a straight track with a pole hinged to it; q = (x, theta): cart position, m; pole angle from the upward vertical, rad. */
#ifndef CART_POLE_H
#define CART_POLE_H

typedef struct {
  double cart_mass;   /* kg */
  double pole_mass;   /* kg, uniform rod */
  double pole_length; /* m */
  double gravity;     /* m/s^2 */
  double push;        /* horizontal force on the cart, N */
  double cart_drag;   /* viscous friction of the cart, N s/m */
  double hinge_drag;  /* viscous friction of the hinge, N m s/rad */
} cart_pole;

double cart_pole_lagrangian(const double q[2], const double qd[2], const cart_pole *p);

/* Generalized force out = (N, N m): the push and the friction. */
void cart_pole_force(const double q[2], const double qd[2], const cart_pole *p, double out[2]);

#endif
