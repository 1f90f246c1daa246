"""Three softened bodies: complex positions, three pairs written out."""
from mpmath import conj, mpc, mpf, sqrt

n = 6
points = [
    ([0.5, -1.0, 0.3, 0.2, 0.4, -0.9], [0.3, -0.2, 0.8, 0.9, -0.5, 0.1], 0.0),
    ([1.9, -0.4, -1.2, 0.7, -1.6, 1.1], [-1.1, 0.6, 0.2, 0.4, 1.3, -0.7], 0.0),
    ([0.5, 0.51, -0.8, 0.2, 0.19, -0.9], [0.3, -0.2, 0.8, 0.9, -0.5, 0.1], 0.0, 'two bodies within the softening length'),
]
a, b, c = mpf(1), mpf(1.3), mpf(0.7)
soft = mpf(0.01)


def lagrangian(q, qd, t):
    za, zb, zc = (mpc(x, y) for x, y in zip(q[:3], q[3:]))
    va, vb, vc = (mpc(x, y) for x, y in zip(qd[:3], qd[3:]))

    def square(z):
        return (z * conj(z)).real

    return ((a * square(va) + b * square(vb) + c * square(vc)) / 2 + a * b / sqrt(square(za - zb) + soft)
            + b * c / sqrt(square(zb - zc) + soft) + c * a / sqrt(square(zc - za) + soft))
