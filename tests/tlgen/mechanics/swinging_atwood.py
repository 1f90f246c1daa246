"""Swinging Atwood's machine by Cartesian coordinates of the swinging mass, and string length for the other."""
from mpmath import mpf, sin, cos

n = 2
m, M, R, I, g = map(mpf, (0.8, 1.9, 0.05, 4.0e-4, 9.81))
points = [
    ([0.7, 0.6], [0.4, -1.2], 0.0),
    ([1.4, -2.3], [-0.9, 0.7], 0.0),
    ([0.35, 1.8], [1.1, 3.4], 0.0),
    ([1e-4, 1.8], [1.1, 3.4], 0.0, "free string nearly used up: the mass matrix is singular at r = 0"),
]


def lagrangian(q, qd, t):
    r, th = q
    rd, w = qd
    # position R (cos, sin) + r (sin, -cos)
    xd = -R * sin(th) * w + rd * sin(th) + r * cos(th) * w
    yd = R * cos(th) * w - rd * cos(th) + r * sin(th) * w
    string = rd - R * w
    spin = string / R
    kinetic = m * (xd ** 2 + yd ** 2) + M * string ** 2 + 2 * I * spin ** 2
    return kinetic / 2 - m * g * (R * sin(th) - r * cos(th)) - M * g * (r - R * th)
