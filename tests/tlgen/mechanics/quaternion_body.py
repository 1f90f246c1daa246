"""Rigid body by a quaternion: angular velocity by the 3x4 matrix G(q), rotation by its nine polynomials."""
from mpmath import mpf

n = 4
mass, g = mpf(1.3), mpf(9.81)
inertia = [mpf(0.21), mpf(0.34), mpf(0.12)]
centre = [mpf(0.05), mpf(-0.02), mpf(0.3)]
points = [
    ([0.85, 0.2, -0.4, 0.4], [0.3, -0.7, 0.9, 0.65], 0.0),
    ([0.15, 0.7, 0.5, -0.5], [-1.2, 0.4, 0.2, 0.52], 0.0),
    ([0.9, -0.3, 0.6, 0.2], [0.5, 1.1, -0.8, 0.3], 0.0),
    ([0.001, 0.002, -0.001, 0.003], [0.3, -0.7, 0.9, 0.65], 0.0, "quaternion nearly zero"),
]


def lagrangian(q, qd, t):
    w, x, y, z = q
    G = [[-x, w, z, -y], [-y, -z, w, x], [-z, y, -x, w]]
    omega = [2 * sum(a * b for a, b in zip(row, qd)) for row in G]
    height_row = [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]
    height = sum(a * b for a, b in zip(height_row, centre))
    return sum(i * o * o for i, o in zip(inertia, omega)) / 2 - mass * g * height


def holonomic(q, t):
    return [q[0] ** 2 + q[1] ** 2 + q[2] ** 2 + q[3] ** 2 - 1]
