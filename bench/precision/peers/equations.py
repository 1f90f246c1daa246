"""The report's scenes as a user of the rivals would write them: Lagrangian, dissipation, forces and constraints on any kind of expression."""
from collections import namedtuple

# lagrangian(f, q, qd), dissipation(f, q, qd) or None, force: a list or None, loops(f, q) or None; f has sin, cos and sqrt.
Model = namedtuple("Model", "lagrangian dissipation force loops", defaults=(None, None, None))


def kepler(f, q, qd):
    return 0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) + 1.0 / f.sqrt(q[0] * q[0] + q[1] * q[1])


def pendulum_sums(f, q, qd):
    """m = l = 1, g = 9.81: each mass with its velocity and height, added up along the chain."""
    vx = vy = drop = result = 0.0
    for angle, rate in zip(q, qd):
        vx = vx + f.cos(angle) * rate
        vy = vy + f.sin(angle) * rate
        drop = drop + f.cos(angle)
        result = result + 0.5 * (vx * vx + vy * vy) + 9.81 * drop
    return result


def pendulum_product(f, q, qd):
    """The same, multiplied out by hand: one term for each pair of links."""
    n, result = len(q), 0.0
    for i in range(n):
        below = float(n - i)
        result = result + 0.5 * below * (qd[i] * qd[i]) + below * 9.81 * f.cos(q[i])
        for j in range(i):
            result = result + below * (f.cos(q[i]) * f.cos(q[j]) + f.sin(q[i]) * f.sin(q[j])) * (qd[i] * qd[j])
    return result


def spring(f, q, qd):
    stretch = q[0] - 1.0
    return 0.5 * (qd[0] * qd[0] + q[0] * q[0] * (qd[1] * qd[1])) + 9.81 * q[0] * f.cos(q[1]) - 0.5 * 9.81e6 * stretch * stretch


# ---- the flyball governor: q = (turn, two arms, height), as in examples/models/flyball.c ----

ARM_LENGTH, ARM_MASS, SECTION, BALL, SHAFT, SLIDER, SIDE = 1.0, 0.3, 0.01, 5.0, 0.3, 3.0, 0.1
HINGE_RADIUS, HINGE_HEIGHT, STIFFNESS, DAMPING, REST, GRAVITY = 0.05, 1.0, 8e5, 4e4, 0.5, 9.81


def spring_length(f, alpha, height):
    """(from the slider's end to the middle of the arm: outwards, upwards, length)"""
    out = 0.5 * ARM_LENGTH * f.cos(alpha)
    up = HINGE_HEIGHT - 0.5 * ARM_LENGTH * f.sin(alpha) - height
    return out, up, f.sqrt(out * out + up * up)


def arm(f, alpha, rate, turn):
    c, s = f.cos(alpha), f.sin(alpha)
    across, along = ARM_MASS * (ARM_LENGTH**2 + SECTION**2) / 12, ARM_MASS * SECTION**2 / 6
    middle, end = HINGE_RADIUS + 0.5 * ARM_LENGTH * c, HINGE_RADIUS + ARM_LENGTH * c
    about_shaft = ARM_MASS * middle * middle + BALL * end * end + across * c * c + along * s * s
    about_hinge = (0.25 * ARM_MASS + BALL) * ARM_LENGTH**2 + across
    height = ARM_MASS * (HINGE_HEIGHT - 0.5 * ARM_LENGTH * s) + BALL * (HINGE_HEIGHT - ARM_LENGTH * s)
    return 0.5 * about_shaft * turn * turn + 0.5 * about_hinge * rate * rate - GRAVITY * height


def flyball(f, q, qd):
    inertia = (SHAFT * SECTION**2 + SLIDER * SIDE**2) / 6
    result = 0.5 * inertia * qd[0] * qd[0] + SLIDER * (0.5 * qd[3] * qd[3] - GRAVITY * q[3])
    for i in (1, 2):
        stretch = spring_length(f, q[i], q[3])[2] - REST
        result = result + arm(f, q[i], qd[i], qd[0]) - 0.5 * STIFFNESS * stretch * stretch
    return result


def flyball_dampers(f, q, qd):
    """Half of the damping times the square of the rate of each spring's length."""
    result = 0.0
    for i in (1, 2):
        out, up, length = spring_length(f, q[i], q[3])
        half = 0.5 * ARM_LENGTH
        rate = (-half * (out * f.sin(q[i]) + up * f.cos(q[i])) * qd[i] - up * qd[3]) / length
        result = result + 0.5 * DAMPING * rate * rate
    return result


# ---- Andrews' squeezing mechanism, as in examples/models/andrews.c; names of the Test Set ----

M1, M2, M3, M4, M5, M6, M7 = 0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498
I1, I2, I3, I4, I5, I6, I7 = 2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5
XA, YA, XB, YB, XC, YC = -0.06934, -0.00227, -0.03635, 0.03273, 0.014, 0.072
D, DA, E, EA, RR, RA, SS, SA, SB, SC, SD = 28e-3, 115e-4, 2e-2, 1421e-5, 7e-3, 92e-5, 35e-3, 1874e-5, 1043e-5, 18e-3, 2e-2
TA, TB, U, UA, UB, ZF, ZT, FA, C0, L0, MOM = 2308e-5, 916e-5, 4e-2, 1228e-5, 449e-5, 2e-2, 4e-2, 1421e-5, 4530.0, 0.07785, 0.033


def lever(turn, rod_rate, lever_rate, reach, length, m_rod, i_rod, m_lever, i_lever, across, along):
    rod, mixed = m_rod * reach * reach + i_rod, m_rod * (reach * reach + length * reach * turn) + i_rod
    both = (m_rod * (length * length + 2.0 * length * reach * turn + reach * reach) + m_lever * (across * across + along * along)
            + i_rod + i_lever)
    return 0.5 * rod * rod_rate * rod_rate + mixed * rod_rate * lever_rate + 0.5 * both * lever_rate * lever_rate


def andrews(f, q, qd):
    beta, theta, gamma, phi, delta, omega, epsilon = range(7)
    along = DA * RR * f.cos(q[theta])
    m11, m12, m22 = M1 * RA**2 + M2 * (RR**2 - 2.0 * along + DA**2) + I1 + I2, M2 * (DA**2 - along) + I2, M2 * DA**2 + I2
    T = 0.5 * m11 * qd[beta] * qd[beta] + m12 * qd[beta] * qd[theta] + 0.5 * m22 * qd[theta] * qd[theta]
    T = T + 0.5 * (M3 * (SA**2 + SB**2) + I3) * qd[gamma] * qd[gamma]
    T = T + lever(f.sin(q[phi]), qd[phi], qd[delta], E - EA, ZT, M4, I4, M5, I5, TA, TB)
    T = T + lever(-f.sin(q[omega]), qd[omega], qd[epsilon], ZF - FA, U, M6, I6, M7, I7, UA, UB)
    x = XB + SD * f.cos(q[gamma]) + SC * f.sin(q[gamma]) - XC
    y = YB + SD * f.sin(q[gamma]) - SC * f.cos(q[gamma]) - YC
    stretch = f.sqrt(x * x + y * y) - L0
    return T - 0.5 * C0 * stretch * stretch


def andrews_loops(f, q):
    beta, theta, gamma, phi, delta, omega, epsilon = q
    x, y = RR * f.cos(beta) - D * f.cos(beta + theta), RR * f.sin(beta) - D * f.sin(beta + theta)
    return [x - SS * f.sin(gamma) - XB, y + SS * f.cos(gamma) - YB,
            x - E * f.sin(phi + delta) - ZT * f.cos(delta) - XA, y + E * f.cos(phi + delta) - ZT * f.sin(delta) - YA,
            x - ZF * f.cos(omega + epsilon) - U * f.sin(epsilon) - XA, y - ZF * f.sin(omega + epsilon) + U * f.cos(epsilon) - YA]


# By scene: the forms that compete.
FORMS = {
    "kepler05": {"": Model(kepler)},
    "kepler99": {"": Model(kepler)},
    "pendulum2": {"sums": Model(pendulum_sums), "product": Model(pendulum_product)},
    "pendulum6": {"sums": Model(pendulum_sums), "product": Model(pendulum_product)},
    "andrews": {"": Model(andrews, force=[MOM] + 6 * [0.0], loops=andrews_loops)},
    "flyball": {"": Model(flyball, dissipation=flyball_dampers)},
    "spring": {"": Model(spring)},
}
