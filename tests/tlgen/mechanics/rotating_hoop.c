/* Bead on a hoop that is spun up about a vertical axis beside its centre, while the axle is shaken along x.
 * Everything is in the laboratory frame: place and velocity of the bead as vectors, the drive as a function of time. */
#include "linear3.h"

typedef struct { double angle, rate; } drive_t;

static const double radius = 0.4, aside = 0.15, mass = 0.08, gravity = 9.81;

/* from rest to full speed with a smooth ramp, then a slow modulation */
static drive_t drive(double t)
{
    const double full = 6.0, tau = 0.8, depth = 0.5, beat = 1.7;
    drive_t d;
    d.angle = full * (t - tau * (1. - exp(-t / tau))) + depth * sin(beat * t);
    d.rate = full * (1. - exp(-t / tau)) + depth * beat * cos(beat * t);
    return d;
}

double bead_on_hoop(const double q[static 1], const double qd[static 1], double t)
{
    drive_t d = drive(t);
    v3 up = { 0., 0., 1. }, local = { aside + radius * sin(q[0]), 0., -radius * cos(q[0]) };
    v3 tangent = { radius * cos(q[0]), 0., radius * sin(q[0]) };
    v3 place, velocity, carried, shake = { 0.05 * 3.1 * cos(3.1 * t), 0., 0. };
    m3 turn;

    m3_rotate_axis(turn, 2, d.angle);
    m3_mul_v3(place, turn, local);
    m3_mul_v3(velocity, turn, tangent);
    v3_scale(velocity, velocity, qd[0]);
    v3_mul_cross(carried, up, place);
    v3_scale(carried, carried, d.rate);
    v3_add(velocity, velocity, carried);
    v3_add(velocity, velocity, shake);
    return mass * (v3_mul_inner(velocity, velocity) / 2. - gravity * v3_mul_inner(place, up));
}
