"""FPUT chain: polynomials of the stretches of the six bonds of a chain with its walls as masses."""
from mpmath import mpf

n = 5
points = [
    ([0.4, -0.2, 0.7, 0.1, -0.5], [1.0, 0.3, -0.6, 0.8, -1.1], 0.0),
    ([-0.9, 0.6, 0.2, -1.3, 0.4], [0.5, -0.7, 1.9, 0.1, 0.6], 0.0),
    ([2.1, 1.4, -0.8, 0.3, 1.7], [-0.2, 1.2, 0.4, -0.9, 0.7], 0.0),
]
mass = [mpf(v) for v in (1.0, 1.0, 1.2, 1.0, 0.9)]
k = [mpf(v) for v in (1.0, 1.0, 1.1, 1.0, 1.0, 0.8)]
alpha = [mpf(v) for v in (0.25, 0.25, -0.25, 0.25, 0.25, 0)]
beta = [mpf(v) for v in (0.5, 0.5, 0.5, 0.7, 0, 0.3)]


def lagrangian(q, qd, t):
    x = [mpf(0)] + list(q) + [mpf(0)]
    r = [b - a for a, b in zip(x, x[1:])]
    return (sum(m * v**2 for m, v in zip(mass, qd)) / 2
            - sum(c2 * s**2 / 2 + c3 * s**3 / 3 + c4 * s**4 / 4 for c2, c3, c4, s in zip(k, alpha, beta, r)))
