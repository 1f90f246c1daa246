/* Coil gun in the small: a coil on a spring rides along the axis of a fixed one; each closes a circuit with a capacitor and a resistor.
 * Maxwell's mutual inductance of two coaxial loops, with elliptic integrals from a library. */
#include "elliptic.h"

#include <math.h>

struct coil { double radius, turns, inductance, capacitance, resistance; };

struct gun
{
    struct coil fixed, moving;
    double mass, spring, rest, mu;
};

const struct gun toy_gun =
{
    { 0.60, 3.0, 3.4, 0.40, 0.8 },
    { 0.45, 2.0, 2.6, 0.25, 0.3 },
    0.7, 5.0, 0.3, 0.5
};

double mutual_inductance(const struct coil *a, const struct coil *b, double distance, double mu)
{
    double product = a->radius * b->radius, sum = a->radius + b->radius;
    double m = 4.0 * product / (sum * sum + distance * distance), k = sqrt(m);

    return mu * a->turns * b->turns * sqrt(product) * ((2.0 / k - k) * ellint_K(m) - 2.0 / k * ellint_E(m));
}

double gun_lagrangian(const struct gun *gun, const double *q, const double *qd)
{
    const struct coil *a = &gun->fixed, *b = &gun->moving;
    double x = q[0], v = qd[0], i1 = qd[1], i2 = qd[2];
    double magnetic = a->inductance * i1 * i1 / 2.0 + b->inductance * i2 * i2 / 2.0 + mutual_inductance(a, b, x, gun->mu) * i1 * i2;
    double electric = q[1] * q[1] / (2.0 * a->capacitance) + q[2] * q[2] / (2.0 * b->capacitance);

    return gun->mass * v * v / 2.0 - gun->spring * (x - gun->rest) * (x - gun->rest) / 2.0 + magnetic - electric;
}

void gun_losses(const struct gun *gun, const double *qd, double *out)
{
    out[0] = 0.0;
    out[1] = -gun->fixed.resistance * qd[1];
    out[2] = -gun->moving.resistance * qd[2];
}
