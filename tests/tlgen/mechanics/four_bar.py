"""Four-bar linkage by complex-number algebra on the law of cosines: energies from squared speeds written as sums of cosines."""
from mpmath import mpf, sin, cos, exp

n = 3
m, l, c, J = zip(*[[mpf(v) for v in row] for row in ((0.5, 0.12, 0.06, 8.0e-4), (1.1, 0.38, 0.17, 1.5e-2), (0.8, 0.29, 0.14, 6.0e-3))])
px, py, g = mpf(0.34), mpf(0.05), mpf(9.81)
points = [
    ([0.9, 0.45, 1.3], [2.0, -0.7, 0.4], 0.5),
    ([2.3, 0.3, 1.9], [-1.5, 0.6, 1.1], 1.2),
    ([4.4, 0.8, 1.0], [3.1, 0.2, -0.9], 2.5),
    ([0.4, 0.4001, 0.4002], [2.0, -0.7, 0.4], 0.5, "bars nearly aligned: dead centre of the linkage"),
]


def lagrangian(q, qd, t):
    a, b, r = q
    u, v, w = qd
    kinetic = (J[0] + m[0] * c[0] ** 2) * u ** 2 + (J[2] + m[2] * c[2] ** 2) * w ** 2
    kinetic += m[1] * (l[0] ** 2 * u ** 2 + c[1] ** 2 * v ** 2 + 2 * l[0] * c[1] * u * v * cos(a - b)) + J[1] * v ** 2
    moment = m[0] * c[0] * sin(a) + m[1] * (l[0] * sin(a) + c[1] * sin(b)) + m[2] * (py + c[2] * sin(r))
    return kinetic / 2 - g * moment - (r - mpf(1.4)) ** 2


def holonomic(q, t):
    a, b, r = q
    return [l[0] * cos(a) + l[1] * cos(b) - l[2] * cos(r) - px, l[0] * sin(a) + l[1] * sin(b) - l[2] * sin(r) - py]


def force(q, qd, t):
    return [mpf(0.3) * (1 - exp(-t)) - mpf(0.05) * qd[0], mpf(0), mpf(0)]
