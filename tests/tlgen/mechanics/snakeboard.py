"""Snakeboard: energies of board, rotor and axles; no slip as velocity of each axle's centre across its heading."""
from mpmath import mpf, sin, cos

n = 6
m, J, Jr, Jw, half, slope, kp, kd, amp, freq, g = map(mpf, (6.0, 0.016, 0.072, 0.0013, 0.2, 0.05, 2.5, 0.4, 0.7, 3.0, 9.81))
points = [
    ([0.3, -0.2, 0.5, 0.4, -0.6, 0.7], [0.5, 0.1, 0.8, -1.1, 0.6, -0.4], 0.3),
    ([1.3, 0.9, -1.5, 2.4, 0.35, -0.5], [-0.7, 0.9, 0.3, 1.9, -1.6, 0.9], 1.7),
    ([-0.4, 0.6, 2.5, 0.1, 0.9, 0.2], [0.2, 0.4, -1.3, 0.7, 0.1, 1.2], 0.9),
    ([0.3, -0.2, 0.5, 0.4, 1.5705, 1.5709], [0.5, 0.1, 0.8, -1.1, 0.6, -0.4], 0.3,
     "wheels nearly across the board: both conditions nearly say the same"),
]


def lagrangian(q, qd, t):
    xd, yd, w, wr, wb, wf = qd
    kinetic = m * (xd ** 2 + yd ** 2) + J * w ** 2 + Jr * (w + wr) ** 2 + Jw * ((w + wb) ** 2 + (w + wf) ** 2)
    return kinetic / 2 - m * g * q[0] * sin(slope)


def across(q, qd, arm, steer):
    """Velocity of the point at `arm` ahead of the centre, along the normal of its axle's heading."""
    v = [qd[0] - arm * qd[2] * sin(q[2]), qd[1] + arm * qd[2] * cos(q[2])]
    heading = q[2] + steer
    return cos(heading) * v[1] - sin(heading) * v[0]


def nonholonomic(q, qd, t):
    return [across(q, qd, -half, q[4]), across(q, qd, half, q[5])]


def force(q, qd, t):
    def drive(i, sign):
        want, rate = sign * amp * sin(freq * t), sign * amp * freq * cos(freq * t)
        return kp * (want - q[i]) + kd * (rate - qd[i])

    return [mpf(0)] * 3 + [drive(3, 1), drive(4, -1), drive(5, 1)]
