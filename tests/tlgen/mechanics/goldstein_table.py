"""Two masses on a string through a hole in a table, both in Cartesian positions."""
from mpmath import mpf, sin, cos

n = 4
m1, m2, length, g = map(mpf, (1.1, 0.7, 1.6, 9.81))
points = [
    ([0.6, 0.7, 0.5, 1.2], [0.3, 1.9, -0.8, 1.1], 0.0),
    ([1.1, -2.2, 1.4, -0.6], [-0.5, 0.7, 1.6, -2.2], 0.0),
    ([0.9, 3.1, 2.5, 0.2], [0.8, -1.4, 0.3, 0.9], 0.0),
    ([0.9, 3.1, 1e-4, 0.2], [0.8, -1.4, 0.3, 0.9], 0.0, "string nearly vertical: its azimuth has no inertia there"),
]


def lagrangian(q, qd, t):
    r, phi, th, psi = q
    rd, phid, thd, psid = qd
    v1 = [rd * cos(phi) - r * sin(phi) * phid, rd * sin(phi) + r * cos(phi) * phid]
    s, sd = length - r, -rd
    rho, rhod = s * sin(th), sd * sin(th) + s * cos(th) * thd
    v2 = [rhod * cos(psi) - rho * sin(psi) * psid, rhod * sin(psi) + rho * cos(psi) * psid, -(sd * cos(th) - s * sin(th) * thd)]
    return m1 * sum(v ** 2 for v in v1) / 2 + m2 * sum(v ** 2 for v in v2) / 2 + m2 * g * s * cos(th)
