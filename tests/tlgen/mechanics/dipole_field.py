"""A charge among magnets: v.A as the triple products mu.(r x v)/r^3 and B.(r x v)/2, written as determinants."""
from mpmath import det, matrix, mpf, norm

n = 3
points = [
    ([0.9, 0.4, -0.6], [0.7, -1.2, 0.5], 0.0),
    ([-1.3, 0.8, 1.1], [0.2, 0.9, -1.4], 0.0),
    ([1.6, -1.9, 0.3], [-2.0, 0.6, 0.8], 0.0),
    ([2.505, -1.0, 0.51], [-2.0, 0.6, 0.8], 0.0, 'a hundredth beside a magnet'),
]
mass, charge = mpf(0.9), mpf(-1.6)
field, electric = [mpf(0), mpf(-0.2), mpf(1.1)], [mpf(0.3), mpf(0), mpf(0.4)]
magnets = [([mpf(0)] * 3, [mpf(0.1), mpf(0), mpf(0.8)]), ([mpf(2.5), mpf(-1), mpf(0.5)], [mpf(-0.5), mpf(0.6), mpf(0.1)])]


def lagrangian(q, qd, t):
    total = mass * sum(v * v for v in qd) / 2 + charge * sum(e * x for e, x in zip(electric, q))
    total += charge * det(matrix([field, q, qd])) / 2
    for place, moment in magnets:
        r = [x - p for x, p in zip(q, place)]
        total += charge * det(matrix([moment, r, qd])) / norm(r)**3
    return total
