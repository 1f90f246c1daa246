"""Chaplygin sleigh in its expanded form: T = m v^2/2 + (I + m a^2) w^2/2 + m a w (v . normal)."""
from mpmath import mpf, sin, cos

n = 3
m, I, a, g, tilt = map(mpf, (2.0, 0.15, 0.25, 9.81, 0.02))
damping = [mpf(0.3), mpf(0.3), mpf(0.05)]
points = [
    ([0.4, -0.3, 0.7], [0.9, 0.4, 1.3], 2.0),
    ([-1.4, 0.8, 2.9], [-0.2, 1.4, -0.6], 11.0),
    ([0.1, 0.2, -1.1], [0.7, -1.2, 2.3], 5.5),
]


def lagrangian(q, qd, t):
    x, y, th = q
    xd, yd, w = qd
    kinetic = m * (xd ** 2 + yd ** 2) / 2 + (I + m * a ** 2) * w ** 2 / 2 + m * a * w * (yd * cos(th) - xd * sin(th))
    return kinetic - m * g * sin(tilt * t) * (x + a * cos(th))


def nonholonomic(q, qd, t):
    normal = (-sin(q[2]), cos(q[2]))
    return [qd[0] * normal[0] + qd[1] * normal[1]]


def force(q, qd, t):
    return [-c * v for c, v in zip(damping, qd)]
