"""Carriages between stops: sums of one-sided powers max(0, s - s0)^k, one for each change of stiffness."""
from mpmath import mpf

n = 2
points = [
    ([0.2, 0.45], [0.6, -0.4], 0.0),     # free
    ([0.3, 0.91], [0.5, 0.7], 0.0),      # in the rubber, soft coupling
    ([-1.06, -0.3], [-0.8, 0.2], 0.0),   # in the steel, hard coupling
    ([-0.9, 1.04], [0.3, 1.1], 0.0),     # both, coupling beyond the third range
    ([0.3, 0.85000001], [0.5, 0.7], 0.0, '1e-8 inside the rubber'),
]
RAIL, PLAY, STOP, BUMPER_K, BUMPER = map(mpf, (1.0, 0.3, 800.0, 150.0, 0.15))
masses = [mpf(2), mpf(1.2)]


def beyond(s, limit):
    return max(mpf(0), s - limit)


def lagrangian(q, qd, t):
    total = sum(m * v * v for m, v in zip(masses, qd)) / 2
    for x in q:
        s = abs(x)
        total -= (BUMPER_K * beyond(s, RAIL - BUMPER)**2 + (STOP - BUMPER_K) * beyond(s, RAIL)**2) / 2
    s = abs(q[1] - q[0])
    return total - 20 * beyond(s, PLAY)**2 - 25 * beyond(s, 2 * PLAY)**2 - 300 * beyond(s, 3 * PLAY)**3


def force(q, qd, t):
    out = []
    for x, v in zip(q, qd):
        side = 1 if x > 0 else -1
        out.append(-30 * side * beyond(abs(x), RAIL - BUMPER) * beyond(side * v, 0))
    return out
