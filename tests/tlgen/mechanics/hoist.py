"""Hoist, its losses as the forces that they are."""
from mpmath import cos, mpf, sqrt

n = 3
trolley, load, rope, grip, creep, brake, oil, air, thrust, g = map(mpf, (120.0, 350.0, 4.0, 60.0, 0.05, 9.0, 14.0, 2.5, 200.0, 9.81))
points = [
    ([0.3, 1.5, -3.8], [0.8, 1.1, 0.35], 0.4),
    ([-1.0, -1.6, -3.9], [-0.02, 0.4, -0.5], 2.1),   # the trolley hardly creeps
    ([2.0, 5.0, 2.6], [-1.5, 0.25, 3.0], 0.75),
]


def lagrangian(q, qd, t):
    return trolley * qd[0] ** 2 / 2 + load * (qd[1] ** 2 + qd[2] ** 2) / 2 - load * g * q[2]


def holonomic(q, t):
    return [((q[1] - q[0]) ** 2 + q[2] ** 2 - rope ** 2) / 2]


def force(q, qd, t):
    # the rope's direction is (sin, -cos) of the angle; oil in its joint resists the angle's rate by a torque
    x, z = q[1] - q[0], q[2]
    torque = -oil * (x * qd[2] - z * (qd[1] - qd[0])) / (x ** 2 + z ** 2)
    across = [-z / (x ** 2 + z ** 2) * torque, x / (x ** 2 + z ** 2) * torque]   # on the load
    speed = sqrt(qd[1] ** 2 + qd[2] ** 2)
    rail = -grip * qd[0] / sqrt(qd[0] ** 2 + creep ** 2) - brake * t * qd[0]
    return [thrust * cos(3 * t) + rail - across[0], across[0] - air * speed * qd[1], across[1] - air * speed * qd[2]]
