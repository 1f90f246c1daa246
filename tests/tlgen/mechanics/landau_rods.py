"""Landau's rods by the kinetic energy as printed: T = m l^2 (1 + 3 sin^2 phi) phid^2 / 3."""
from mpmath import mpf, sin, cos

n = 1
m, l, k, rest, g = map(mpf, (0.6, 0.5, 40.0, 0.8, 9.81))
points = [([0.7], [1.3], 0.0), ([1.3], [-3.6], 0.0), ([2.6], [5.1], 0.0), ([-0.4], [0.9], 0.0)]


def lagrangian(q, qd, t):
    phi, w = q[0], qd[0]
    kinetic = m * l ** 2 * (1 + 3 * sin(phi) ** 2) * w ** 2 / 3
    return kinetic - m * g * l * sin(phi) - k * (2 * l * cos(phi) - rest) ** 2 / 2
