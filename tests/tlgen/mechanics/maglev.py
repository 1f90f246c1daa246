"""Levitated ball with its circuit: magnetic coenergy, capacitor, and the inductance as one quotient."""
from mpmath import mpf, sin, exp, log

n = 2
m, g, far, near, gap, R, C = map(mpf, (0.068, 9.81, 0.25, 0.375, 4.0e-3, 7.5, 2.2e-3))
points = [
    ([3.0e-3, 0.01], [0.2, 1.4], 0.05),
    ([9.0e-3, -0.004], [-0.4, 0.6], 0.8),
    ([1.2e-3, 0.02], [0.05, -2.1], 1.9),
]


def lagrangian(q, qd, t):
    inductance = far + near * log((2 * gap + q[0]) / (gap + q[0]))
    return (m * qd[0] ** 2 + inductance * qd[1] ** 2 - q[1] ** 2 / C) / 2 + m * g * q[0]


def force(q, qd, t):
    return [-mpf(1e-3) * qd[0], 12 + 2 * sin(300 * t) * exp(-t) - R * qd[1]]
