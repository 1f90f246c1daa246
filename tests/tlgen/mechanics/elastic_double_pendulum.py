"""Elastic double pendulum in Cartesian positions and velocities."""
from mpmath import mpf, sin, cos

n = 4
m, k, l = [mpf(0.7), mpf(0.4)], [mpf(85.0), mpf(60.0)], [mpf(0.5), mpf(0.35)]
g = mpf(9.81)
points = [
    ([0.55, 0.7, 0.41, -0.9], [0.3, 1.1, -0.4, 2.1], 0.0),
    ([0.47, -2.2, 0.5, 1.6], [-0.8, 0.6, 0.9, -1.5], 0.0),
    ([0.61, 0.1, 0.33, 0.25], [0.2, -3.1, 0.5, 1.4], 0.0),
    ([0.61, 0.1, 1e-5, 0.25], [0.2, -3.1, 0.5, 1.4], 0.0, "second spring nearly at zero length"),
]


def lagrangian(q, qd, t):
    x = y = xd = yd = total = mpf(0)
    for i in range(2):
        r, th, rd, thd = q[2 * i], q[2 * i + 1], qd[2 * i], qd[2 * i + 1]
        x, y = x + r * sin(th), y - r * cos(th)
        xd, yd = xd + rd * sin(th) + r * thd * cos(th), yd - rd * cos(th) + r * thd * sin(th)
        total += m[i] * (xd ** 2 + yd ** 2) / 2 - m[i] * g * y - k[i] * (r - l[i]) ** 2 / 2
    return total
