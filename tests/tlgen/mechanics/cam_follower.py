"""Cam and rocker: the rocker's angle from the triangle of disc centre, roller centre and pivot, by the law of cosines."""
from mpmath import mpf, sin, cos, acos, atan2, pi, sqrt

n = 1
px, arm, e, reach = map(mpf, (0.080, 0.055, 0.012, 0.045))
J1, J2, k, rest, motor = map(mpf, (6.5e-4, 2.2e-4, 9.0, 1.9, 0.8))
points = [
    ([0.7], [40.0], 0.0),
    ([2.6], [-15.0], 0.0),
    ([4.9], [25.0], 0.0),
    ([6.1], [55.0], 0.0),
]


def rocker(th):
    dx, dy = e * cos(th) - px, e * sin(th)  # from the pivot to the disc's centre
    d2 = dx ** 2 + dy ** 2
    opening = acos((arm ** 2 + d2 - reach ** 2) / (2 * arm * sqrt(d2)))
    return (atan2(dy, dx) % (2 * pi)) - opening


def slope(th):
    # The roller's velocity across the line of centres is free; along it both centres move alike.
    psi = rocker(th)
    ux, uy = px + arm * cos(psi) - e * cos(th), arm * sin(psi) - e * sin(th)
    return e * (-ux * sin(th) + uy * cos(th)) / (arm * (-ux * sin(psi) + uy * cos(psi)))


def lagrangian(q, qd, t):
    th, w = q[0], qd[0]
    return ((J1 + J2 * slope(th) ** 2) * w ** 2 - k * (rocker(th) - rest) ** 2) / 2


def force(q, qd, t):
    return [motor * (1 - qd[0] / 60)]
