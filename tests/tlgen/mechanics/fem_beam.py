"""Cantilever by exact integrals of its cubic polynomials on each element, without matrices or quadrature."""
from mpmath import mpf, cos

n = 8
h, EI, rhoA, k1, k3 = map(mpf, (0.25, 3.0, 0.8, 15.0, 400.0))
points = [
    ([0.01, 0.08, 0.05, 0.2, -0.04, -0.5, -0.1, 0.4], [0.3, -1.0, 0.5, 0.8, -0.7, 0.2, 1.1, -0.6], 0.3),
    ([0.05, 0.3, 0.12, 0.35, 0.2, 0.3, 0.27, 0.2], [-0.2, 0.4, -0.5, -0.1, 0.6, 1.2, 0.9, 0.5], 1.1),
    ([-0.03, 0.2, 0.06, -0.6, 0.15, 0.9, 0.02, -0.3], [0.8, 0.1, -0.4, 0.9, 0.3, -1.1, -0.2, 0.7], 2.9),
]


def cubic(w0, s0, w1, s1):
    """Coefficients in x/h of the cubic with these end values and slopes."""
    return [w0, h * s0, 3 * (w1 - w0) - h * (2 * s0 + s1), 2 * (w0 - w1) + h * (s0 + s1)]


def times(a, b):
    c = [mpf(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


def integral(a):
    return h * sum(c / (i + 1) for i, c in enumerate(a))


def lagrangian(q, qd, t):
    total = mpf(0)
    u, v = [mpf(0)] * 2 + list(q), [mpf(0)] * 2 + list(qd)
    for e in range(4):
        w, wd = cubic(*u[2 * e:2 * e + 4]), cubic(*v[2 * e:2 * e + 4])
        bend = [2 * w[2] / h ** 2, 6 * w[3] / h ** 2]
        w2 = times(w, w)
        total += integral(times(wd, wd)) * rhoA / 2 - integral(times(bend, bend)) * EI / 2
        total -= integral(w2) * k1 / 2 + integral(times(w2, w2)) * k3 / 4
    return total


def force(q, qd, t):
    p = 2 * cos(5 * t)
    basis = [[mpf(i == j) for j in range(4)] for i in range(4)]
    return [-mpf(0.01) * v + (p * integral(cubic(*basis[i - 4])) if i >= 4 else 0) for i, v in enumerate(qd)]
