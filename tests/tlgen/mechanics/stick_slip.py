"""Blocks on a moving belt: stiffness and damping matrices; tanh from exponentials."""
from mpmath import exp, matrix, mpf, sin

n = 3
points = [
    ([0.15, 0.42, 0.75], [0.36, 0.1, -0.4], 0.3),
    ([0.02, 0.5, 0.6], [0.34, 0.4, 0.45], 1.1),
    ([0.3, 0.35, 0.7], [-0.8, 0.33, 0.9], 2.0),
]
mass = [mpf(1), mpf(0.6), mpf(1.4)]
k1, k2, k3, l1, l2, l3, d1, d2, drag = map(mpf, (40, 25, 30, 0.1, 0.3, 0.25, 0.2, 0.3, 0.7))
normal = [mpf(v) for v in (3.5, 2.0, 4.5)]
width = [mpf(v) for v in (0.02, 0.05, 0.1)]
belt, strobe, fall = mpf(0.35), mpf(7), mpf(0.4)
K = matrix([[k1 + k2, -k2, 0], [-k2, k2 + k3, -k3], [0, -k3, k3]])
pull = matrix([k1 * l1 - k2 * l2, k2 * l2 - k3 * l3, k3 * l3])
rest = (k1 * l1**2 + k2 * l2**2 + k3 * l3**2) / 2


def lagrangian(q, qd, t):
    x = matrix(q)
    return sum(m * v * v for m, v in zip(mass, qd)) / 2 - (x.T * K * x)[0] / 2 + (pull.T * x)[0] - rest


def force(q, qd, t):
    out = [-d1 * qd[0] - d2 * (qd[0] - qd[1]), -d2 * (qd[1] - qd[0]), -drag * qd[2] * abs(qd[2])]
    moving = belt * (1 + sin(strobe * t) * mpf(0.1))
    for i in range(n):
        s = qd[i] - moving
        e = exp(2 * s / width[i])
        out[i] -= normal[i] * (e - 1) / (e + 1) * (1 - fall + fall * exp(-abs(s)))
    return out
