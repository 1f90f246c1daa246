"""Two coaxial coils with their circuits: the mutual inductance in Maxwell's second form, with mpmath's K and E."""
from mpmath import ellipe, ellipk, mpf, sqrt

n = 3
points = [
    ([0.4, 0.3, -0.2], [0.9, 1.4, -0.8], 0.0),
    ([-0.7, -0.5, 0.6], [0.2, -1.1, 2.0], 0.0),
    ([1.6, 0.2, 0.4], [-1.3, 0.7, 0.5], 0.0),
    ([0.0, 0.3, -0.2], [0.9, 1.4, -0.8], 0.0),
]
a, b, mu, turns = mpf(0.60), mpf(0.45), mpf(0.5), mpf(6)
L1, C1, R1, L2, C2, R2 = map(mpf, (3.4, 0.40, 0.8, 2.6, 0.25, 0.3))
mass, spring, rest = map(mpf, (0.7, 5.0, 0.3))


def mutual(x):
    """Landen's transformed form: moduli from the largest and least distance of the loops, r1 and r2; (r1 - r2)/(r1 + r2) is the new one."""
    r1, r2 = sqrt((a + b)**2 + x**2), sqrt((a - b)**2 + x**2)
    m = ((r1 - r2) / (r1 + r2))**2
    return mu * turns * (r1 + r2) * (ellipk(m) - ellipe(m))


def lagrangian(q, qd, t):
    magnetic = L1 * qd[1]**2 / 2 + L2 * qd[2]**2 / 2 + mutual(q[0]) * qd[1] * qd[2]
    return mass * qd[0]**2 / 2 - spring * (q[0] - rest)**2 / 2 + magnetic - q[1]**2 / (2 * C1) - q[2]**2 / (2 * C2)


def force(q, qd, t):
    return [mpf(0), -R1 * qd[1], -R2 * qd[2]]
