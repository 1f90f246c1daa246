"""Bead on a rotating, shaken hoop: velocity in the hoop's own axes, with the shaking resolved along them."""
from mpmath import cos, exp, mpf, sin

n = 1
points = [
    ([0.7], [1.9], 0.0),
    ([2.2], [-3.0], 0.6),
    ([-1.1], [0.4], 3.7),
    ([0.5], [0.1], 40.0),
]
R, aside, mass, g = map(mpf, (0.4, 0.15, 0.08, 9.81))
full, tau, depth, beat, shake, pace = map(mpf, (6, 0.8, 0.5, 1.7, 0.05, 3.1))


def lagrangian(q, qd, t):
    ramp = 1 - exp(-t / tau)
    angle = full * (t - tau * ramp) + depth * sin(beat * t)
    rate = full * ramp + depth * beat * cos(beat * t)
    axle = shake * pace * cos(pace * t)
    outward = R * cos(q[0]) * qd[0] + axle * cos(angle)
    around = (aside + R * sin(q[0])) * rate - axle * sin(angle)
    upward = R * sin(q[0]) * qd[0]
    return mass * (outward**2 + around**2 + upward**2) / 2 + mass * g * R * cos(q[0])
