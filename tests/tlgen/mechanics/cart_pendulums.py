"""Cart with a chain of pendulums by its closed double sum over tail masses."""
from mpmath import mpf, cos

links = 3
n = links + 1
M, k, g = mpf(2.5), mpf(12), mpf(9.81)
m, l = [mpf(x) for x in (0.9, 0.6, 0.4)], [mpf(x) for x in (0.7, 0.5, 0.45)]
tail = [sum(m[i:]) for i in range(links)]
points = [
    ([0.3, 0.7, -0.4, 1.9], [0.5, -1.1, 2.0, 0.3], 0.0),
    ([-0.6, 2.9, 1.3, -2.2], [0.2, 0.4, -0.9, 3.1], 0.0),
    ([0.1, -0.2, 0.15, 0.3], [-1.4, 2.2, 1.7, -0.8], 0.0),
]


def lagrangian(q, qd, t):
    th, w = q[1:], qd[1:]
    kinetic = (M + tail[0]) * qd[0] ** 2
    for i in range(links):
        kinetic += 2 * tail[i] * l[i] * w[i] * qd[0] * cos(th[i])
        for j in range(links):
            kinetic += tail[max(i, j)] * l[i] * l[j] * w[i] * w[j] * cos(th[i] - th[j])
    return kinetic / 2 + g * sum(tail[i] * l[i] * cos(th[i]) for i in range(links)) - k * q[0] ** 2 / 2


def force(q, qd, t):
    c = mpf(0.02)
    relative = [qd[1]] + [qd[i] - qd[i - 1] for i in range(2, n)] + [mpf(0)]
    return [-mpf(0.4) * qd[0]] + [-c * (relative[i] - (relative[i + 1] if i + 1 < links else 0)) for i in range(links)]
