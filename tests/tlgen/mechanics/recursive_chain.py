"""Chain of rods: M(absolute angles) from the mass that hangs on each joint, in closed form."""
from mpmath import cos, mpf

n = 4
points = [
    ([0.5, -0.3, 0.9, -1.2], [1.0, 0.4, -2.0, 3.0], 0.0),
    ([2.2, 0.7, -1.6, 0.4], [-1.5, 2.5, 0.3, -0.9], 0.0),
    ([-1.0, -1.3, 2.7, 1.1], [0.2, -3.0, 1.4, 5.0], 0.0),
]
g, tip = mpf(9.81), mpf(0.05)
length = [mpf(v) for v in (0.8, 0.6, 0.45, 0.3)]
mass = [mpf(v) for v in (1.1, 0.7, 0.4, 0.2)]
beyond = [sum(mass[i + 1:]) + tip for i in range(n)]           # what hangs at the end of rod i
moment = [length[i] * (mass[i] / 2 + beyond[i]) for i in range(n)]


def lagrangian(q, qd, t):
    a = [sum(q[:i + 1]) for i in range(n)]
    w = [sum(qd[:i + 1]) for i in range(n)]
    total = mpf(0)
    for i in range(n):
        total += (mass[i] / 3 + beyond[i]) * length[i]**2 * w[i]**2 / 2 + g * moment[i] * cos(a[i])
        for j in range(i):
            total += length[j] * moment[i] * w[i] * w[j] * cos(a[i] - a[j])
    return total
