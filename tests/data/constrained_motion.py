#!/usr/bin/env python3
"""Prints constrained_motion.txt: accelerations, multipliers and their derivatives of the models in tests/runtime/constrained_models.c.
With --gains 3 5 it prints stabilised_motion.txt: the same with Baumgarte's terms for alpha = 3 and beta = 5 1/s.

Shares nothing with the library: M, Q, A, b by central differences of plain functions in 220-digit arithmetic (steps 1e-50: errors of
1e-90), qdd and lambda by Gaussian elimination of [M -A'; A 0], derivatives by central differences of the solution (step 1e-24: errors
below 1e-40). Numbers are the doubles that the C models use. Needs mpmath.
"""
import random
import sys
from mpmath import mp, mpf, sin, cos, sqrt, matrix, lu_solve, nstr

mp.dps = 220
H = mpf(10) ** -50   # differences of the model's functions
H2 = mpf(10) ** -24  # differences of the solution
G = mpf(9.81)
ALPHA, BETA = [mpf(x) for x in sys.argv[2:4]] if sys.argv[1:2] == ['--gains'] else (0, 0)


def quaternion_rates(q, v):
    return (-q[1]*v[0] + q[0]*v[1] + q[3]*v[2] - q[2]*v[3],
            -q[2]*v[0] - q[3]*v[1] + q[0]*v[2] + q[1]*v[3],
            -q[3]*v[0] + q[2]*v[1] - q[1]*v[2] + q[0]*v[3])


def top(q, v, t):
    w = quaternion_rates(q, v)
    return 2*w[0]**2 + 2*w[1]**2 + w[2]**2 - 2*(q[0]**2 + q[3]**2 - q[1]**2 - q[2]**2)


def bead(q, v, t):
    return mpf(1)/2*(v[0]**2 + v[1]**2 + v[2]**2) - G*q[2]


def none(q, v, t):
    return []


MODELS = {  # name: n, L, Gamma, phi, psi
    'cartesian_pendulum': (2, lambda q, v, t: v[0]**2 + v[1]**2 - 2*G*q[1], none,
                           lambda q, t: [q[0]**2 + q[1]**2 - 1], none),
    'cartesian_double_pendulum': (
        4, lambda q, v, t: (v[0]**2 + v[1]**2)/2 + mpf(3)/2*(v[2]**2 + v[3]**2) - G*(q[1] + 3*q[3]),
        lambda q, v, t: [mpf(-0.3)*x for x in v],
        lambda q, t: [q[0]**2 + q[1]**2 - 1, (q[2] - q[0])**2 + (q[3] - q[1])**2 - 1], none),
    'central_field': (
        4, lambda q, v, t: sum((v[0]*q[i] + q[0]*v[i])**2 for i in (1, 2, 3)) + 2*mpf(1.7)/q[0], none,
        lambda q, t: [q[1]**2 + q[2]**2 + q[3]**2 - 1], none),
    'rotating_hoop': (3, bead, none,
                      lambda q, t: [q[0]**2 + q[1]**2 + q[2]**2 - 1, q[0]*sin(2*t) - q[1]*cos(2*t)], none),
    'sleigh': (3, lambda q, v, t: (v[0] - v[2]/4*sin(q[2]))**2 + (v[1] + v[2]/4*cos(q[2]))**2 + mpf(0.4)*v[2]**2,
               lambda q, v, t: [mpf(-0.1)*v[0], mpf(-0.2)*v[1]**3, sin(t)],
               lambda q, t: [], lambda q, v, t: [v[0]*sin(q[2]) - v[1]*cos(q[2])]),
    'appell': (3, bead, none, lambda q, t: [], lambda q, v, t: [v[0]**2 + v[1]**2 - mpf(0.7)*v[2]**2]),
    'quaternion_top': (4, top, none, lambda q, t: [sum(x*x for x in q) - 1], none),
    'mixed': (3, lambda q, v, t: ((1 + q[0]**2)*v[0]**2 + v[1]**2 + v[2]**2)/2 + mpf(0.6)*(q[0]*v[1] - q[1]*v[0]) - G*q[2],
              lambda q, v, t: [mpf(-0.2)*x**3 for x in v],
              lambda q, t: [q[2] - q[0]**2/2 - q[1]**2], lambda q, v, t: [v[1] - q[2]*v[0] - sin(t)]),
    'relativistic': (
        3, lambda q, v, t: -25*sqrt(1 - mpf(0.04)*(v[0]**2 + v[1]**2 + v[2]**2)) + mpf(0.8)*(q[0]*v[1] - q[1]*v[0]) + q[2]*sin(t),
        none, lambda q, t: [q[0]**2 + q[1]**2 + q[2]**2 - 1], none),
    'massless': (2, lambda q, v, t: v[0]**2/2 - 4*q[1], none, lambda q, t: [q[1] - q[0] - q[0]**2/2], none),
}


def moved(x, i, h):
    return [x[k] + (h if k == i else 0) for k in range(len(x))]


def solve(model, q, v, t):
    """qdd and lambda of M qdd - A' lambda = Q, A qdd = b, less 2 alpha phi' + beta^2 phi and alpha psi in b."""
    n, L, force, phi, psi = model

    def mixed_difference(f):  # d2f/da db at 0
        return (f(H, H) - f(H, -H) - f(-H, H) + f(-H, -H))/(4*H*H)

    M = [[mixed_difference(lambda a, c: L(q, moved(moved(v, i, a), j, c), t)) for j in range(n)] for i in range(n)]

    def along(a):  # the motion with qdd = 0
        return [q[k] + a*v[k] for k in range(n)], t + a

    Q = []
    for i in range(n):
        drift = mixed_difference(lambda a, c: L(along(a)[0], moved(v, i, c), along(a)[1]))
        Q.append((L(moved(q, i, H), v, t) - L(moved(q, i, -H), v, t))/(2*H) - drift)
    for i, g in enumerate(force(q, v, t)):
        Q[i] += g
    A, b = [], []
    for r in range(len(phi(q, t))):
        A.append([(phi(moved(q, k, H), t)[r] - phi(moved(q, k, -H), t)[r])/(2*H) for k in range(n)])
        before, now, after = phi(*along(-H))[r], phi(q, t)[r], phi(*along(H))[r]
        b.append(-(after - 2*now + before)/H**2 - ALPHA*(after - before)/H - BETA**2*now)
    for r in range(len(psi(q, v, t))):
        A.append([(psi(q, moved(v, k, H), t)[r] - psi(q, moved(v, k, -H), t)[r])/(2*H) for k in range(n)])
        b.append(-(psi(along(H)[0], v, along(H)[1])[r] - psi(along(-H)[0], v, along(-H)[1])[r])/(2*H)
                 - ALPHA*psi(q, v, t)[r])
    m = len(A)
    K = matrix(n + m, n + m)
    for i in range(n):
        for j in range(n):
            K[i, j] = M[i][j]
        for r in range(m):
            K[i, n + r] = -A[r][i]
            K[n + r, i] = A[r][i]
    x = lu_solve(K, matrix(Q + b))
    return [x[i] for i in range(n + m)]


def main():
    random.seed(30)
    print(f'# Constrained motion in 40 digits, printed by {" ".join(["constrained_motion.py"] + sys.argv[1:])}. Each line: model n m t q[n] qd[n] qdd[n] lambda[m]')
    print('# dqdd/d(q,qd)[n x 2n] dlambda/d(q,qd)[m x 2n].')
    for name, model in MODELS.items():
        n = model[0]
        for _ in range(4):
            q = [mpf(random.uniform(0.3, 1.2)*random.choice((1, -1) if i or name != 'central_field' else (1,))) for i in range(n)]
            v = [mpf(random.uniform(-1.5, 1.5)) for _ in range(n)]
            t = mpf(random.uniform(0, 2))
            x = solve(model, q, v, t)
            columns = []
            for j in range(2*n):
                y = q + v
                hi, lo = moved(y, j, H2), moved(y, j, -H2)
                up, down = solve(model, hi[:n], hi[n:], t), solve(model, lo[:n], lo[n:], t)
                columns.append([(a - c)/(2*H2) for a, c in zip(up, down)])
            rows = [columns[j][i] for i in range(len(x)) for j in range(2*n)]
            print(name, n, len(x) - n, *[repr(float(a)) for a in [t] + q + v], *[nstr(a, 40) for a in x + rows])


main()
