"""Andrews' squeezing mechanism with bodies in the complex plane: a point that turns at angle a has the velocity i a' times its arm."""
from mpmath import mpf, mpc, expj, re, im

n = 7
m = [mpf(v) for v in (0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498)]
J = [mpf(v) for v in (2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5)]
A, B, C = mpc(-0.06934, -0.00227), mpc(-0.03635, 0.03273), mpc(0.014, 0.072)
d, da, e, ea, rr, ra, ss, sc, sd, u, zf, zt, fa = [
    mpf(v) for v in (28e-3, 115e-4, 2e-2, 1421e-5, 7e-3, 92e-5, 35e-3, 18e-3, 2e-2, 4e-2, 2e-2, 4e-2, 1421e-5)]
third, fifth, seventh = mpc(1874e-5, 1043e-5), mpc(2308e-5, 916e-5), mpc(1228e-5, 449e-5)  # centres of mass in their bodies
c0, l0, torque = mpf(4530.0), mpf(0.07785), mpf(0.033)
points = [
    ([-0.06, 0.01, 0.45, 0.22, 0.49, -0.23, 1.22], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], 0.0),
    ([0.9, -0.6, 0.43, 0.31, 0.45, -0.29, 1.21], [310.0, -250.0, 15.0, -21.0, 13.0, 8.0, -17.0], 0.0),
    ([3.4, -2.1, 0.37, 0.52, 0.38, -0.55, 1.13], [-120.0, 190.0, -9.0, 14.0, 7.0, -31.0, 22.0], 0.0),
]


def arms(q):
    """Lists of (body's angle as rates' indices, arm) whose sum is each body's centre of mass, and the ends of the three loops."""
    beta, theta, gamma, phi, delta, omega, epsilon = q
    crank, rod, plate = expj(beta), expj(beta + theta), expj(gamma)
    lever, short, other, long = expj(delta), -1j * expj(phi + delta), -1j * expj(epsilon), expj(omega + epsilon)
    centres = [
        [((0,), ra * crank)],
        [((0,), rr * crank), ((0, 1), -da * rod)],
        [((2,), third * plate)],
        [((4,), zt * lever), ((3, 4), (e - ea) * short)],
        [((4,), fifth * lever)],
        [((6,), u * other), ((5, 6), (zf - fa) * long)],
        [((6,), seventh * 1j * other)],
    ]
    end = rr * crank - d * rod
    return centres, [end - B + 1j * ss * plate, end - A - zt * lever - e * short, end - A - u * other - zf * long]


def lagrangian(q, qd, t):
    turns = [(0,), (0, 1), (2,), (3, 4), (4,), (5, 6), (6,)]
    energy = mpf(0)
    for body, centre in enumerate(arms(q)[0]):
        v = sum(1j * sum(qd[k] for k in which) * arm for which, arm in centre)
        energy += m[body] * (re(v) ** 2 + im(v) ** 2) / 2 + J[body] * sum(qd[k] for k in turns[body]) ** 2 / 2
    stretch = abs(B + mpc(sd, -sc) * expj(q[2]) - C) - l0
    return energy - c0 * stretch ** 2 / 2


def force(q, qd, t):
    return [torque] + [mpf(0)] * 6


def holonomic(q, t):
    return [part(end) for end in arms(q)[1] for part in (re, im)]
