"""Satellite with reaction wheels: body rate from the time derivative of the rotation matrix, in inertial space, by the chain rule."""
from mpmath import mpf, sin, cos, sqrt

n = 7
W, Jw, s3 = mpf(1.08e-1), mpf(0.04), mpf(0.57735026918962576451)
J = [[mpf(v) for v in row] for row in ((9.2, -0.3, 0.2), (-0.3, 11.5, 0.4), (0.2, 0.4, 7.1))]
axes = [(s3, s3, s3), (-s3, s3, s3), (-s3, -s3, s3), (s3, -s3, s3)]
points = [
    ([0.2, -0.3, 0.5, 1.0, 2.0, -0.7, 0.4], [0.1, 0.05, -0.2, 30.0, -25.0, 12.0, 8.0], 0.0),
    ([-1.4, 0.8, 2.9, 0.1, -0.6, 0.9, 2.2], [-0.3, 0.6, 0.2, -4.0, 5.5, 3.0, -2.0], 0.0),
    ([2.1, 1.5707, 0.7, 0.1, -0.6, 0.9, 2.2], [-0.3, 0.6, 0.2, -4.0, 5.5, 3.0, -2.0], 0.0, "pitch nearly at gimbal lock"),
]


def dcm(q):
    """Orbital to body, elements of the 3-2-1 sequence as tabulated."""
    (a, b, c), (A, B, C) = [sin(x) for x in q[:3]], [cos(x) for x in q[:3]]
    return [[B * C, B * c, -b], [a * b * C - A * c, a * b * c + A * C, a * B], [A * b * C + a * c, A * b * c - a * C, A * B]]


def dcm_dot(q, qd):
    (a, b, c), (A, B, C) = [sin(x) for x in q[:3]], [cos(x) for x in q[:3]]
    by_roll = [[0, 0, 0], [A * b * C + a * c, A * b * c - a * C, A * B], [-a * b * C + A * c, -a * b * c - A * C, -a * B]]
    by_pitch = [[-b * C, -b * c, -B], [a * B * C, a * B * c, -a * b], [A * B * C, A * B * c, -A * b]]
    by_yaw = [[-B * c, B * C, 0], [-a * b * c - A * C, a * b * C - A * c, 0], [-A * b * c + a * C, A * b * C + a * c, 0]]
    return [[by_roll[i][j] * qd[0] + by_pitch[i][j] * qd[1] + by_yaw[i][j] * qd[2] for j in range(3)] for i in range(3)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def form(a):
    return dot(a, [dot(row, a) for row in J])


def lagrangian(q, qd, t):
    R, Rd = dcm(q), dcm_dot(q, qd)
    # Rd R' = -[w x] for the rate to the orbital frame, which itself turns at -W about its y axis
    w = [dot(Rd[1], R[2]) - W * R[0][1], dot(Rd[2], R[0]) - W * R[1][1], dot(Rd[0], R[1]) - W * R[2][1]]
    wheels = sum((qd[3 + i] + dot(axes[i], w)) ** 2 for i in range(4))
    nadir = [row[2] for row in R]
    return (form(w) + Jw * wheels) / 2 - 3 * W ** 2 * form(nadir) / 2


def force(q, qd, t):
    u = [mpf(0.2) * dot(a, q[:3]) + mpf(0.5) * dot(a, qd[:3]) for a in axes]
    return [mpf(0)] * 3 + [c / sqrt(1 + c ** 2) - mpf(1.0e-3) * v for c, v in zip(u, qd[3:])]
