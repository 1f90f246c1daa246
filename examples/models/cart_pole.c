/* Lagrangian and force of the cart with a pole. */
#include "cart_pole.h"
#include <math.h>

static double square(double x) { return x * x; }

/* Speed of the pole's centre, squared. */
static double centre_speed2(double half, double theta, double xd, double thetad)
{
    return square(xd + half * thetad * cos(theta)) + square(half * thetad * sin(theta));
}

double cart_pole_lagrangian(const double q[2], const double qd[2], const cart_pole *p)
{
    const double half = p->pole_length / 2;
    const double inertia = p->pole_mass * square(p->pole_length) / 12;
    const double theta = q[1], xd = qd[0], thetad = qd[1];
    double kinetic, potential;

    kinetic = p->cart_mass * square(xd) / 2;
    kinetic += p->pole_mass * centre_speed2(half, theta, xd, thetad) / 2;
    kinetic += inertia * square(thetad) / 2;
    potential = p->pole_mass * p->gravity * half * cos(theta);
    return kinetic - potential;
}

void cart_pole_force(const double q[2], const double qd[2], const cart_pole *p, double out[2])
{
    (void)q;
    out[0] = p->push - p->cart_drag * qd[0];
    out[1] = -p->hinge_drag * qd[1];
}
