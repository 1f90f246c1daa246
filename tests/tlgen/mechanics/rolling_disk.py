"""Rolling disk with vectors of space: the unit vectors to its centre, ahead and along the axle; no slip from the contact's velocity."""
from mpmath import mpf, sin, cos

n = 5
m, r, g = mpf(1.5), mpf(0.35), mpf(9.81)
points = [
    ([0.4, -0.3, 0.7, 0.3, 1.1], [0.9, 0.4, 0.8, -0.5, -2.1], 0.0),
    ([-1.4, 0.8, 2.9, -0.6, 0.2], [-0.2, 1.4, -1.6, 0.4, 3.2], 0.0),
    ([0.1, 0.2, -1.1, 0.9, -0.4], [0.7, -1.2, 0.3, 1.1, 1.7], 0.0),
    ([0.1, 0.2, -1.1, 1.5707, -0.4], [0.7, -1.2, 0.3, 1.1, 1.7], 0.0,
     "disk nearly flat: the mass matrix without the constraints is singular there"),
]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def motion(q, qd):
    """Axle, angular velocity, velocity of the centre, and that of the disk's point at the contact."""
    yaw, lean = q[2:4]
    heading = [cos(yaw), sin(yaw), mpf(0)]
    up = [sin(lean) * sin(yaw), -sin(lean) * cos(yaw), cos(lean)]  # from the contact to the centre
    axle = cross(up, heading)
    frame_rate = [qd[3] * heading[0], qd[3] * heading[1], qd[2]]
    rate = [a + qd[4] * b for a, b in zip(frame_rate, axle)]
    centre = [a + r * b for a, b in zip(qd[:2] + [mpf(0)], cross(frame_rate, up))]
    contact = [a - r * b for a, b in zip(centre, cross(rate, up))]
    return axle, rate, centre, contact


def lagrangian(q, qd, t):
    axle, rate, centre, _ = motion(q, qd)
    diameter = m * r ** 2 / 4
    kinetic = m * dot(centre, centre) + diameter * dot(rate, rate) + diameter * dot(rate, axle) ** 2
    return kinetic / 2 - m * g * r * cos(q[3])


def nonholonomic(q, qd, t):
    return motion(q, qd)[3][:2]
