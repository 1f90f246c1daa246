"""Foucault pendulum seen from space: the position in a non-rotating frame at angle W t about the polar axis, and its velocity."""
from mpmath import mpf, sin, cos, sqrt

n = 3
W, B, length, m, g = map(mpf, (7.292115e-2, 0.8527, 3.2, 28.0, 9.81))
points = [
    ([0.8, -0.5, -2.9], [0.4, 0.9, 0.2], 0.0),
    ([-1.7, 1.1, -2.4], [-0.6, 0.3, -0.8], 0.0),
    ([0.3, 2.2, 1.4], [1.5, -0.7, 0.9], 0.0),
    ([0.3, 2.2, 1.4], [1e-7, -2e-7, 1e-7], 0.0, "nearly at rest: the drag has no second derivative at v = 0"),
]


def lagrangian(q, qd, t):
    # Unit vectors: polar axis p, meridian direction e outward from it, east. South = sin(B) e - cos(B) p; up = cos(B) e + sin(B) p.
    def split(v):
        return v[0] * sin(B) + v[2] * cos(B), v[1], v[2] * sin(B) - v[0] * cos(B)

    (e, y, _), (ed, yd, pd) = split(q), split(qd)
    c, s = cos(W * t), sin(W * t)
    velocity = [c * ed - s * yd - W * (s * e + c * y), s * ed + c * yd + W * (c * e - s * y), pd]
    return m * sum(u ** 2 for u in velocity) / 2 - m * g * q[2]


def holonomic(q, t):
    return [q[0] ** 2 + q[1] ** 2 + q[2] ** 2 - length ** 2]


def force(q, qd, t):
    speed = sqrt(qd[0] ** 2 + qd[1] ** 2 + qd[2] ** 2)
    return [-mpf(0.02) * speed * u for u in qd]
