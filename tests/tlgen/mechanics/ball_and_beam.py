"""Ball and beam: the ball's centre by position vector; quadratic form of the speed written out."""
from mpmath import mpf, sin, cos, exp

n = 2
m, Jb, J, rho, h, g = map(mpf, (0.11, 1.76e-5, 0.03, 0.013, 0.02, 9.81))
gains = [mpf(8), mpf(5), mpf(25), mpf(4)]
points = [
    ([0.14, 0.2], [0.3, -0.5], 0.4),
    ([-0.2, -0.35], [0.1, 0.8], 2.2),
    ([0.05, 0.6], [-0.4, 0.1], 5.3),
]


def lagrangian(q, qd, t):
    x, a = q
    v, w = qd
    speed2 = v ** 2 - 2 * h * v * w + (x ** 2 + h ** 2) * w ** 2
    return (m * speed2 + Jb * (w - v / rho) ** 2 + J * w ** 2) / 2 - m * g * (x * sin(a) + h * cos(a))


def force(q, qd, t):
    u = -(gains[0] * (q[0] - mpf(0.1) * cos(t)) + gains[1] * qd[0] + gains[2] * q[1] + gains[3] * qd[1])
    return [mpf(0), 2 * (1 - 2 / (exp(u) + 1))]
