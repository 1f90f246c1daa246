"""Orbit about an oblate planet: distance by two hypotenuses, latitude by its sine."""
from mpmath import hypot, mpf

n = 3
points = [
    ([1.1, 0.4, -0.7], [-0.5, 1.3, 0.6], 0.0),
    ([-2.0, 1.5, 0.9], [0.3, 0.8, -1.1], 0.0),
    ([0.2, -0.9, 0.8], [1.7, 0.1, 0.4], 0.0),
    ([1e-3, -2e-3, 1e-3], [1.7, 0.1, 0.4], 0.0, 'close to the centre'),
]
gm, radius, j2 = mpf(4), mpf(0.7), mpf(0.03)


def lagrangian(q, qd, t):
    r = hypot(hypot(q[0], q[1]), q[2])
    sine = q[2] / r
    return sum(v**2 for v in qd) / 2 + gm / r * (1 - j2 * (radius / r)**2 * (3 * sine**2 - 1) / 2)
