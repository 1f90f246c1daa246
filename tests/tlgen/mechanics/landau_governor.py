"""Centrifugal governor from the Cartesian positions of its masses."""
from mpmath import mpf, sin, cos

n = 1
m1, m2, a, W, g = map(mpf, (0.5, 1.2, 0.4, 9.0, 9.81))
points = [([0.7], [1.3], 0.0), ([1.2], [-2.6], 0.0), ([2.3], [4.2], 0.0), ([0.2], [-0.4], 0.0)]


def lagrangian(q, qd, t):
    th, w = q[0], qd[0]
    total = mpf(0)
    for side in (1, -1):
        r, z = side * a * sin(th), -a * cos(th)
        rd, zd = side * a * cos(th) * w, a * sin(th) * w
        total += m1 * (rd ** 2 + zd ** 2 + (r * W) ** 2) / 2 - m1 * g * z
    sleeve, sleeve_v = -2 * a * cos(th), 2 * a * sin(th) * w
    return total + m2 * sleeve_v ** 2 / 2 - m2 * g * sleeve
