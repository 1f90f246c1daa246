"""A puck on measured ground: the height as a sum of 16 products of cardinal weights, its slopes from the weights' own derivatives."""
from bisect import bisect_left

from mpmath import mpf

n = 2
points = [
    ([0.3, 0.2], [0.8, -0.6], 0.0),
    ([-1.7, 1.1], [-0.4, 1.3], 0.0),
    ([2.1, -1.2], [1.5, 0.9], 0.0),
    ([3.6, 3.2], [-0.7, -1.1], 0.0),   # beyond the last inner cell
]
easting = [mpf(v) for v in (-4.0, -2.5, -1.0, 0.0, 1.25, 2.5, 4.0)]
northing = [mpf(v) for v in (-3.0, -1.5, -0.5, 0.75, 2.0, 3.5)]
height = [[mpf(v) for v in row] for row in (
    (12, 18, 25, 31, 22, 15, 9), (20, 35, 41, 38, 30, 19, 11), (26, 44, 62, 57, 36, 25, 18),
    (31, 40, 58, 71, 49, 33, 27), (22, 29, 37, 46, 52, 41, 35), (8, 16, 21, 30, 38, 47, 44))]
scale, mass, g = mpf(0.01), mpf(0.17), mpf(9.81)


def weights(grid, x):
    """The place of the first of four grid lines, their weights and the derivatives of these."""
    i = min(max(bisect_left(grid, x), 2), len(grid) - 2) - 2
    a, b, c, d = grid[i:i + 4]
    h = c - b
    u = (x - b) / h
    h01, h10, h11 = u * u * (3 - 2 * u), u * (1 - u)**2 * h, u * u * (u - 1) * h
    d01, d10, d11 = 6 * u * (1 - u) / h, (1 - u) * (1 - 3 * u), u * (3 * u - 2)
    left, right = 1 / (c - a), 1 / (d - b)
    return (i, [-left * h10, 1 - h01 - right * h11, h01 + left * h10, right * h11],
            [-left * d10, -d01 - right * d11, d01 + left * d10, right * d11])


def lagrangian(q, qd, t):
    i, wx, dx = weights(easting, q[0])
    j, wy, dy = weights(northing, q[1])
    z = east = north = mpf(0)
    for k in range(4):
        for l in range(4):
            h = scale * height[j + k][i + l]
            z += h * wy[k] * wx[l]
            east += h * wy[k] * dx[l]
            north += h * dy[k] * wx[l]
    return mass * (qd[0]**2 + qd[1]**2 + (east * qd[0] + north * qd[1])**2) / 2 - mass * g * z
