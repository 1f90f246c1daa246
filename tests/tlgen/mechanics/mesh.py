"""A net of four knots: complex places, the laws by name; a thread pulls where its stretch is positive."""
from mpmath import exp, mpc, mpf

n = 8
points = [
    ([-0.7, 0.6, 0.8, 0.7, 0.6, -0.9, -0.6, -0.5], [0.4, -0.2, 0.7, 0.3, -0.5, 0.8, 0.1, 0.6], 0.0),
    ([-1.6, 1.4, 0.1, 0.9, 0.5, 0.2, -0.9, -1.3], [-0.3, 1.1, 0.2, -0.6, 0.9, 0.4, -0.8, 0.5], 0.0),
]
mass = [mpf(v) for v in (0.5, 0.25, 0.75, 0.375)]
pins = [mpc(-2, 2), mpc(2, 2), mpc(2, -2), mpc(-2, -2)]
threads = [(a, b, mpf(l), mpf(k), law) for a, b, l, k, law in (
    (0, 1, 1.0, 12, 'hooke'), (1, 2, 1.1, 9, 'slack'), (2, 3, 0.9, 15, 'stiff'), (3, 0, 1.0, 11, 'slack'),
    (0, 4, 1.2, 20, 'slack'), (1, 5, 1.2, 20, 'slack'), (2, 6, 1.2, 20, 'slack'), (3, 7, 1.2, 20, 'hooke'))]


def lagrangian(q, qd, t):
    z = [mpc(q[2 * i], q[2 * i + 1]) for i in range(4)] + pins
    total = mpf(0)
    for i, m in enumerate(mass):
        total += m * (qd[2 * i]**2 + qd[2 * i + 1]**2) / 2 - mpf(9.81) * m * q[2 * i + 1]
    for a, b, length, k, law in threads:
        s = abs(z[a] - z[b]) - length
        if law == 'stiff':
            total -= k * (exp(s) + exp(-s) - 2) / 2
        elif law == 'hooke' or s > 0:
            total -= k * s * s / 2
    return total
