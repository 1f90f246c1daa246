"""Six-axis arm: angular and linear velocities handed outwards from frame to frame, rotations as explicit vectors, no 4x4 matrices."""
from mpmath import cos, mpf, sin

n = 6
points = [
    ([0.3, -0.7, 1.1, 0.5, -0.9, 0.2], [0.6, -0.8, 1.2, -2.0, 0.7, 1.5], 0.0),
    ([-1.4, 0.6, -0.8, 2.2, 1.0, -0.4], [-0.2, 1.1, 0.4, 0.9, -1.6, 3.0], 0.0),
    ([2.0, 0.2, 0.4, -1.1, 0.8, 1.9], [1.0, 0.3, -0.5, 0.1, 2.1, -0.7], 0.0),
]
H = mpf(1.5707963267948966)
table = [  # theta, d, a, alpha, mass, com, squared radii of gyration
    (0, 0.67, 0, -H, 12.0, (0.02, 0.11, 0.05), (0.021, 0.014, 0.018)),
    (-H, 0, 0.43, 0, 15.5, (-0.22, 0.01, 0.16), (0.012, 0.041, 0.043)),
    (0, 0.15, -0.02, H, 5.2, (0.02, -0.07, 0.03), (0.016, 0.004, 0.015)),
    (0, 0.43, 0, -H, 1.3, (0.00, 0.10, 0.01), (0.005, 0.003, 0.004)),
    (0, 0, 0, H, 0.7, (0.01, 0.0, 0.02), (0.001, 0.002, 0.0015)),
    (0, 0.06, 0, 0, 0.4, (0.0, 0.005, 0.03), (0.0012, 0.0011, 0.0007)),
]
table = [tuple([mpf(v) for v in row[:5]] + [[mpf(v) for v in row[5]], [mpf(v) for v in row[6]]]) for row in table]
twists = [(cos(row[3]), sin(row[3])) for row in table]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def lagrangian(q, qd, t):
    w, v, up, height, L = [mpf(0)] * 3, [mpf(0)] * 3, [mpf(0), mpf(0), mpf(1)], mpf(0), mpf(0)  # all in the link's own axes
    for (theta, d, a, alpha, mass, com, gyration), (ca, sa), qi, rate in zip(table, twists, q, qd):
        c, s = cos(qi + theta), sin(qi + theta)

        def inward(u):  # components along the new axes: turned by theta about z, then by alpha about x
            x, y = c * u[0] + s * u[1], -s * u[0] + c * u[1]
            return [x, ca * y + sa * u[2], -sa * y + ca * u[2]]

        w, v, up = inward([w[0], w[1], w[2] + rate]), inward(v), inward(up)
        step = [a, sa * d, ca * d]  # from the last origin to this one
        v = add(v, cross(w, step))
        height += sum(x * y for x, y in zip(up, step))
        at_com = add(v, cross(w, com))
        L += mass * (sum(x * x for x in at_com) + sum(g * x * x for g, x in zip(gyration, w))) / 2
        L -= mpf(9.81) * mass * (height + sum(x * y for x, y in zip(up, com)))
    return L
