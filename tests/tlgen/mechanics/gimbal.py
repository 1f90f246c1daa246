"""Gyroscope in two frames: angular velocities in the inner frame's own axes."""
from mpmath import cos, mpf, sin

n = 3
points = [
    ([0.4, 0.7, 1.0], [0.8, -0.5, 40.0], 0.0),
    ([-2.0, -1.1, 0.3], [-1.9, 2.2, 11.0], 0.0),
    ([1.3, 2.5, -0.6], [0.3, 1.7, -25.0], 0.0),
    ([0.4, 1.5707, 1.0], [0.8, -0.5, 40.0], 0.0, 'frames nearly in one plane (gimbal lock is mild: the outer frame has inertia)'),
]
outer, mass, g, spring, rest = map(mpf, (0.031, 1.4, 9.81, 0.8, 0.1))
inner = [mpf(v) for v in (0.012, 0.017, 0.009)]
rotor = [mpf(v) for v in (0.006, 0.006, 0.011)]
cx, cy, cz = map(mpf, (0.004, -0.002, 0.013))


def lagrangian(q, qd, t):
    s, c = sin(q[1]), cos(q[1])
    w = [qd[1], qd[0] * s, qd[0] * c]
    r = [w[0], w[1], w[2] + qd[2]]
    v2 = (w[1] * cz - w[2] * cy)**2 + (w[2] * cx - w[0] * cz)**2 + (w[0] * cy - w[1] * cx)**2
    kinetic = outer * qd[0]**2 + sum(j * x**2 for j, x in zip(inner, w)) + sum(j * x**2 for j, x in zip(rotor, r)) + mass * v2
    return kinetic / 2 - mass * g * (s * cy + c * cz) - spring * (q[1] - rest)**2 / 2
