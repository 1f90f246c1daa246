"""Five-bar robot by each bar's mass centre and moment of inertia, in Cartesian coordinates."""
from mpmath import mpf, sin, cos

n = 4
length, mass = [mpf(v) for v in (0.3, 0.5, 0.28, 0.52)], [mpf(v) for v in (0.8, 0.5, 0.8, 0.45)]
tool, g = mpf(0.35), mpf(9.81)
motor = [(mpf(-0.15), mpf(0)), (mpf(0.15), mpf(0.02))]
points = [
    ([2.1, 0.7, 0.9, 2.3], [1.2, -0.8, 0.5, 1.6], 0.0),
    ([1.6, 0.4, 0.2, 1.9], [-2.1, 0.6, 1.4, -0.3], 0.0),
    ([2.9, 0.9, -0.4, 2.0], [0.7, 2.2, -1.1, 0.4], 0.0),
    ([0.7, 0.7001, 0.7002, 0.6999], [1.2, -0.8, 0.5, 1.6], 0.0, "all bars nearly parallel: both conditions nearly say the same"),
]


def chains(q, qd):
    """(start, its velocity, angle, rate, number) of each bar, then the end of each chain."""
    bars, tips = [], []
    for side in range(2):
        (x, y), xd, yd = motor[side], mpf(0), mpf(0)
        for i in (2 * side, 2 * side + 1):
            bars.append((x, y, xd, yd, q[i], qd[i], i))
            x, y = x + length[i] * cos(q[i]), y + length[i] * sin(q[i])
            xd, yd = xd - length[i] * sin(q[i]) * qd[i], yd + length[i] * cos(q[i]) * qd[i]
        tips.append((x, y, xd, yd))
    return bars, tips


def lagrangian(q, qd, t):
    bars, tips = chains(q, qd)
    total = tool * ((tips[0][2] ** 2 + tips[0][3] ** 2) / 2 - g * tips[0][1])
    for x, y, xd, yd, a, w, i in bars:
        half = length[i] / 2
        speed2 = (xd - half * sin(a) * w) ** 2 + (yd + half * cos(a) * w) ** 2
        total += mass[i] * (speed2 + length[i] ** 2 * w ** 2 / 12) / 2 - mass[i] * g * (y + half * sin(a))
    return total


def holonomic(q, t):
    _, tips = chains(q, [mpf(0)] * 4)
    return [tips[0][0] - tips[1][0], tips[0][1] - tips[1][1]]
