"""Relativistic charge: the free part from the rapidity, -m c^2 / cosh(artanh(v/c))."""
from mpmath import atanh, cosh, hypot, mpf

n = 2
points = [
    ([0.7, -0.9], [1.2, 0.8], 0.0),
    ([-1.4, 0.3], [-0.4, 2.1], 0.0),
    ([0.5, 1.6], [2.2, -1.5], 0.0),
    ([0.5, 1.6], [2.3999, -1.8], 0.0, 'v = 0.99997 c'),
]
mass, light, coulomb = mpf(0.8), mpf(3), mpf(1.7)
stiffness = [mpf(0.4), mpf(0.9)]


def lagrangian(q, qd, t):
    rapidity = atanh(hypot(*qd) / light)
    return -mass * light**2 / cosh(rapidity) + coulomb / hypot(*q) - sum(k * x * x for k, x in zip(stiffness, q)) / 2
