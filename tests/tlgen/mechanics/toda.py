"""Periodic Toda lattice in Flaschka's variables a_i = exp(-(q_(i+1) - q_i)/2), b_i = p_i; the linear terms cancel around the ring."""
from mpmath import exp, mpf

n = 4
points = [
    ([0.4, -0.7, 0.9, 0.1], [1.0, -0.3, 0.6, -1.2], 0.0),
    ([-1.1, 0.8, 1.9, -0.5], [0.2, 0.7, -1.5, 0.4], 0.0),
    ([0.1, 0.2, -0.3, 0.6], [-2.0, 1.1, 0.9, 0.3], 0.0),
    ([0.0, -9.0, 0.2, 0.1], [-2.0, 1.1, 0.9, 0.3], 0.0, 'a bond compressed by nine lengths'),
]


def lagrangian(q, qd, t):
    a = [exp(-(q[(i + 1) % n] - q[i]) / 2) for i in range(n)]
    return sum(b * b for b in qd) / 2 - sum(x * x for x in a) + n
