"""Planar arm with three revolute joints: closed form with absolute angles and the pair sums of cosines of their differences."""
from mpmath import cos, mpf, sin

n = 3
points = [
    ([0.4, -0.9, 1.3], [0.7, -1.1, 0.5], 0.0),
    ([-1.2, 2.1, 0.3], [1.5, 0.2, -2.4], 0.0),
    ([2.6, 0.8, -1.9], [-0.3, 0.9, 3.1], 1.5),
    ([0.3, 1e-9, -1e-9], [0.2, -1.4, 0.8], 0.0, 'stretched arm'),
]
g, payload = mpf(9.81), mpf(0.35)
length = [mpf(v) for v in (0.50, 0.40, 0.25)]
com = [mpf(v) for v in (0.21, 0.18, 0.11)]
mass = [mpf(v) for v in (3.2, 2.1, 0.9)]
inertia = [mpf(v) for v in (0.081, 0.034, 0.006)]


def lagrangian(q, qd, t):
    angle = [sum(q[:i + 1]) for i in range(n)]
    rate = [sum(qd[:i + 1]) for i in range(n)]
    bodies = [(mass[i], length[:i] + [com[i]]) for i in range(n)] + [(payload, length)]
    total = sum(j * w**2 for j, w in zip(inertia, rate)) / 2
    for m, arms in bodies:
        for i, a in enumerate(arms):
            total -= m * g * a * sin(angle[i])
            for j, b in enumerate(arms):
                total += m * a * b * rate[i] * rate[j] * cos(angle[i] - angle[j]) / 2
    return total
