"""Heavy top: the same body as a rotation matrix R(phi) R(theta) R(psi), its angular velocity from R' dR/dt by the chain rule."""
from mpmath import cos, matrix, mpf, sin

n = 3
A, C, mgl = mpf(0.0042), mpf(0.0017), mpf(0.31)
points = [
    ([0.3, 0.8, -1.1], [2.0, 0.7, 35.0], 0.0),
    ([2.1, 2.3, 0.4], [-1.3, 2.9, 12.0], 0.0),
    ([-0.9, 1.4, 3.0], [0.4, -0.6, -4.0], 2.0),
    ([0.3, 1e-3, -1.1], [2.0, 0.7, 35.0], 0.0, 'nearly upright: Euler angles'),
    ([0.3, 1e-6, -1.1], [2.0, 0.7, 35.0], 0.0, 'all but upright: Euler angles'),
]


def about_z(a):
    return matrix([[cos(a), -sin(a), 0], [sin(a), cos(a), 0], [0, 0, 1]]), matrix([[-sin(a), -cos(a), 0], [cos(a), -sin(a), 0], [0, 0, 0]])


def about_x(a):
    return matrix([[1, 0, 0], [0, cos(a), -sin(a)], [0, sin(a), cos(a)]]), matrix([[0, 0, 0], [0, -sin(a), -cos(a)], [0, cos(a), -sin(a)]])


def lagrangian(q, qd, t):
    (P, dP), (T, dT), (S, dS) = about_z(q[0]), about_x(q[1]), about_z(q[2])
    R = P * T * S
    W = R.T * (dP * T * S * qd[0] + P * dT * S * qd[1] + P * T * dS * qd[2])
    return A * (W[2, 1]**2 + W[0, 2]**2) / 2 + C * W[1, 0]**2 / 2 - mgl * R[2, 2]
