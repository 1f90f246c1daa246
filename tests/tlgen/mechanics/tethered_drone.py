"""Drone on a cable of tension-only segments; distances and saturation through squares and minima."""
from mpmath import mpf, sin, cos, sqrt

n = 9
m = [mpf(0.08), mpf(0.08), mpf(1.4)]
k, l, g = mpf(350), mpf(1.1), mpf(9.81)
points = [
    ([0.5, 0.3, 1.25, 0.9, 0.5, 2.3, 1.4, 0.2, 3.4], [0.3, -0.2, 0.5, 0.4, 0.1, -0.7, 1.1, -0.6, 0.2], 0.4),  # taut
    ([0.3, -0.2, 0.9, 0.6, 0.2, 1.4, 1.5, 0.9, 2.1], [-0.1, 0.6, 0.3, 0.2, -0.4, 0.8, 0.5, 0.3, -0.9], 1.7),  # two slack, last one taut
    ([0.5, 0.7, 0.9, -0.6, 1.2, 1.4, -6.5, 0.9, 2.1], [-0.1, 0.6, 0.3, 0.2, -0.4, 0.8, 0.5, 0.3, -0.9], 2.9),  # thrust saturated
]


def lagrangian(q, qd, t):
    nodes = [[mpf(0), mpf(0), mpf(0.2)]] + [q[3 * i:3 * i + 3] for i in range(3)]
    total = mpf(0)
    for i in range(3):
        distance = sqrt(sum((a - b) ** 2 for a, b in zip(nodes[i + 1], nodes[i])))
        total += m[i] * sum(v ** 2 for v in qd[3 * i:3 * i + 3]) / 2 - m[i] * g * q[3 * i + 2] - k * max(distance - l, 0) ** 2 / 2
    return total


def force(q, qd, t):
    wind = [mpf(1.5), mpf(-0.4), mpf(0)]
    out = [mpf(0.05) * (wind[i % 3] - v) for i, v in enumerate(qd)]
    target = [2 * cos(t), 2 * sin(t), mpf(2.4)]
    u = [6 * (target[i] - q[6 + i]) - mpf(3.5) * qd[6 + i] + (m[2] * g if i == 2 else 0) for i in range(3)]
    part = min(1, 25 / sqrt(sum(c ** 2 for c in u)))
    return out[:6] + [out[6 + i] + part * u[i] for i in range(3)]
