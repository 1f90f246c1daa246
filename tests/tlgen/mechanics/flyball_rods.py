"""Flyball governor with vectors of space: the velocity and angular velocity of each arm in the frame that turns with the shaft."""
from mpmath import mpf, sin, cos, sqrt

n = 4
length, arm_mass, section, ball_mass, shaft_mass, slider_mass, side, radius, hinge, damping, rod, g = [
    mpf(v) for v in (1.0, 0.3, 0.01, 5.0, 0.3, 3.0, 0.1, 0.05, 1.0, 40.0, 0.5, 9.81)]
points = [
    ([0.0, 0.52, 0.53, 0.51], [6.28, 0.0, 0.0, 0.0], 0.0),
    ([0.7, 0.31, 0.36, 0.62], [5.1, 0.8, -0.6, 0.9], 0.0),
    ([-1.2, 0.82, 0.74, 0.31], [-7.3, -1.1, 0.4, 0.5], 0.0),
]


def square(v):
    return sum(x * x for x in v)


def point(turn, a, rate, s):
    """Velocity of the point at s along an arm: (outwards, around, up)."""
    return [-s * sin(a) * rate, (radius + s * cos(a)) * turn, -s * cos(a) * rate]


def lagrangian(q, qd, t):
    turn, up = qd[0], qd[3]
    energy = (shaft_mass * section ** 2 + slider_mass * side ** 2) / 12 * turn ** 2 + slider_mass * (up ** 2 / 2 - g * q[3])
    for a, rate in zip(q[1:3], qd[1:3]):
        along, across = turn * sin(a), [turn * cos(a), rate]
        for mass, s in ((arm_mass, length / 2), (ball_mass, length)):
            energy += mass * (square(point(turn, a, rate, s)) / 2 - g * (hinge - s * sin(a)))
        energy += arm_mass * ((length ** 2 + section ** 2) / 24 * square(across) + section ** 2 / 12 * along ** 2)
    return energy


def ends(q, a):
    """From the slider to the middle of an arm: outwards and up."""
    return [length / 2 * cos(a), hinge - length / 2 * sin(a) - q[3]]


def holonomic(q, t):
    return [sqrt(square(ends(q, a))) - rod for a in q[1:3]]


def force(q, qd, t):
    """Dampers along the rods: minus half the gradient of damping (d length/dt)^2 by the rates."""
    out = [mpf(0)] * 4
    for i in (1, 2):
        x, z = ends(q, q[i])
        by = {i: (-x * length / 2 * sin(q[i]) - z * length / 2 * cos(q[i])) / sqrt(x * x + z * z), 3: -z / sqrt(x * x + z * z)}
        rate = sum(by[k] * qd[k] for k in by)
        for k in by:
            out[k] -= damping * rate * by[k]
    return out
