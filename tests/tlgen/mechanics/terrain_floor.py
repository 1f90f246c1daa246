"""Point mass in a sampled potential: the cubic B-spline as a sum of truncated powers, over all samples of the map, its edges repeated."""
from mpmath import mpf

n = 2
points = [
    ([0.3, 0.2], [0.8, -0.6], 0.0),
    ([-0.7, 1.1], [-0.4, 1.3], 0.0),
    ([1.15, -0.9], [1.5, 0.9], 0.0),
    ([-2.3, 1.9], [-0.7, -1.1], 0.0),   # west of the map
]
sample = [
    (3, 5, 9, 12, 10, 6, 2, 0), (4, 8, 17, 25, 21, 11, 5, 1), (2, 9, 22, 40, 33, 15, 4, -2), (0, 5, 15, 28, 24, 8, -3, -8),
    (-2, 1, 6, 12, 7, -4, -14, -15), (-3, -2, 0, 2, -3, -13, -24, -19), (-2, -3, -4, -5, -9, -16, -21, -14), (0, -1, -3, -6, -8, -11, -12, -7)]
EDGE = 6  # samples beyond each edge


def bump(x):
    """The cubic B-spline at a distance x from its knot, in cells."""
    def ramp(s):
        return s**3 if s > 0 else mpf(0)
    return (ramp(x + 2) - 4 * ramp(x + 1) + 6 * ramp(x) - 4 * ramp(x - 1) + ramp(x - 2)) / 6


def weights(s):
    out = [mpf(0)] * 8
    for k in range(-EDGE, 8 + EDGE):
        if abs(s - k) < 2:
            out[min(max(k, 0), 7)] += bump(s - k)
    return out


def lagrangian(q, qd, t):
    east, north = weights((q[0] + 2) * 2), weights((q[1] + mpf(1.5)) * 2)
    height = sum(north[j] * east[i] * sample[j][i] for j in range(8) for i in range(8))
    return (qd[0]**2 + qd[1]**2) / 2 - height * mpf(0.05)
