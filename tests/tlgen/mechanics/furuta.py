"""Furuta pendulum: positions in the world frame differentiated by the chain rule; the rod's rotation by its known closed form."""
from mpmath import mpf, sin, cos

n = 2
m1, L1, c1, J1 = map(mpf, (0.257, 0.2159, 0.0619, 9.98e-4))
m2, c2 = mpf(0.127), mpf(0.1556)
Jx, Jy, Jz = map(mpf, (1.2e-3, 1.1e-3, 2.0e-5))
R, kt, g = mpf(2.6), mpf(0.00768 * 70.0), mpf(9.81)
d1, d2 = mpf(2.4e-3), mpf(2.4e-4)
points = [
    ([0.4, 0.3], [1.3, -2.2], 0.7),
    ([-2.1, 2.6], [-0.6, 4.1], 2.4),
    ([1.0, -1.2], [5.0, 0.8], 0.1),
]


def lagrangian(q, qd, t):
    a, b = q
    ad, bd = qd
    # mass centre of the rod: L1 radial + c2 (sin b tangential' + cos b up), tangential' = (sin a, -cos a)
    xa, ya = -L1 * sin(a) + c2 * sin(b) * cos(a), L1 * cos(a) + c2 * sin(b) * sin(a)
    xb, yb, zb = c2 * cos(b) * sin(a), -c2 * cos(b) * cos(a), -c2 * sin(b)
    speed2 = (xa * ad + xb * bd) ** 2 + (ya * ad + yb * bd) ** 2 + (zb * bd) ** 2
    spin = Jx * bd ** 2 + (Jy * sin(b) ** 2 + Jz * cos(b) ** 2) * ad ** 2
    return ((J1 + m1 * c1 ** 2) * ad ** 2 + m2 * speed2 + spin) / 2 - m2 * g * c2 * cos(b)


def force(q, qd, t):
    current = (mpf(1.5) * sin(4 * t) - kt * qd[0]) / R
    return [kt * current - d1 * qd[0], -d2 * qd[1]]
