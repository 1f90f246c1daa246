"""Cluster of four atoms: depth*((rm/r)^12 - 2 (rm/r)^6) with the minimum at rm = 2^(1/6) sigma; beyond 4 nothing."""
from mpmath import cbrt, hypot, mpf, sqrt

n = 8
points = [
    ([0.0, 0.1, 1.2, 0.2, 1.1, 1.4, -0.2, 1.1], [0.3, -0.5, 0.8, 0.1, -0.4, 0.6, 0.2, -0.9], 0.0),
    ([0.5, -0.3, -0.6, 0.4, 0.9, 0.8, -0.1, 5.0], [1.0, 0.2, -0.7, 0.4, 0.3, -0.1, 0.6, 0.5], 0.0),
    ([0.0, 0.0, 1.5, 0.1, 2.9, -0.3, 1.4, 1.6], [0.0, 0.4, -1.2, 0.3, 0.7, 0.8, -0.6, 0.1], 0.0),
]
mass = [mpf(v) for v in (1.0, 2.1, 1.0, 2.1)]
depth = [mpf(v) for v in (1.0, 0.7, 1.0, 0.7)]
size = [mpf(v) for v in (1.00, 1.15, 1.00, 1.15)]
pairs = [(i, j, sqrt(depth[i] * depth[j]), cbrt(sqrt(mpf(2))) * (size[i] + size[j]) / 2) for j in range(4) for i in range(j)]


def lagrangian(q, qd, t):
    total = sum(m * (qd[2 * i]**2 + qd[2 * i + 1]**2) for i, m in enumerate(mass)) / 2
    for i, j, e, rm in pairs:
        r = hypot(q[2 * i] - q[2 * j], q[2 * i + 1] - q[2 * j + 1])
        if r < 4:
            s = (rm / r)**6
            total -= e * s * (s - 2)
    return total
