#!/usr/bin/env python3
"""Prints sensitivity.txt: motions of the models in tests/runtime/sensitive_models.c and their derivatives with respect to the initial
state and to parameters, in 40 digits.

Shares nothing with the library: textbook equations of motion in 90 digits, Gragg's extrapolation to order 48 with fixed steps, derivatives
by central differences of the whole motion with steps of 1e-24, errors of 1e-46. The rod's motion is that of its angle. Numbers are the
doubles that the C models use. Needs mpmath; takes some minutes.
"""
from mpmath import mp, mpf, sin, cos, sqrt, nstr

mp.dps = 90
H = mpf(10) ** -24
COLUMNS = 24  # of the extrapolation


def motion(f, t, x, steps):
    h = t / steps
    for _ in range(steps):
        x = extrapolated(f, h, x)
    return x


def extrapolated(f, h, x):
    rows = []
    for j in range(COLUMNS):
        n = 2 * (j + 1)
        row = [midpoint(f, h, n, x)]
        for k in range(j):
            ratio = mpf(n) / (2 * (j - k))
            row.append([a + (a - b) / (ratio**2 - 1) for a, b in zip(row[k], rows[k])])
        rows = row
    return rows[-1]


def midpoint(f, h, n, x):
    d = h / n
    before, now = x, [a + d * b for a, b in zip(x, f(x))]
    for _ in range(n - 1):
        before, now = now, [a + 2 * d * b for a, b in zip(before, f(now))]
    return [(a + b + d * c) / 2 for a, b, c in zip(before, now, f(now))]


def chain(x, p):
    """Two masses on rods, angles from the downward vertical."""
    m1, m2, l1, l2, g = p
    a, b, u, v = x
    d = a - b
    s, c = sin(d), cos(d)
    m = m1 + m2 * s**2
    first = (-m2 * s * (l2 * v**2 + l1 * u**2 * c) - g * (m1 + m2) * sin(a) + m2 * g * sin(b) * c) / (l1 * m)
    second = ((m1 + m2) * (l1 * u**2 * s - g * sin(b) + g * sin(a) * c) + m2 * l2 * v**2 * s * c) / (l2 * m)
    return [u, v, first, second]


def planet(x, p):
    r = sqrt(x[0]**2 + x[1]**2)
    return [x[2], x[3], -p[0] * x[0] / r**3, -p[0] * x[1] / r**3]


def spring(x, p):
    mass, rest, stiffness, gravity = p
    r, a, u, w = x
    return [u, w, r * w**2 + gravity * cos(a) - stiffness / mass * (r - rest), (-2 * u * w - gravity * sin(a)) / r]


def rod(x, p):
    mass, length, gravity = p
    return [x[1], -gravity / length * sin(x[0])]


def on_circle(x, p):
    """The rod's end and its velocity from angle and rate."""
    a, w = x
    return [p[1] * sin(a), -p[1] * cos(a), p[1] * w * cos(a), p[1] * w * sin(a)]


def same(x, p):
    return x


MODELS = {  # equations, t, steps, initial state, parameters, the model's coordinates
    'chain': (chain, 3, 60, [1.2, -0.4, 0.3, 0.7], [1.1, 0.7, 0.9, 1.3, 9.81], same),
    'planet': (planet, 4, 60, [0.6, 0.1, -0.2, 1.3], [1.25], same),
    'spring': (spring, 2, 60, [1.2, 0.5, -0.3, 0.8], [1.5, 1.0, 40.0, 9.81], same),
    'rod': (rod, 3, 40, [1.1, 0.9], [1.3, 0.8, 9.81], on_circle),
}


def differences(f, x):
    """Columns of the derivative of f by its arguments."""
    columns = []
    for j in range(len(x)):
        up, down = list(x), list(x)
        up[j] += H
        down[j] -= H
        columns.append([(a - b) / (2 * H) for a, b in zip(f(up), f(down))])
    return columns


def rows(columns):
    return [column[i] for i in range(len(columns[0])) for column in columns]


def main():
    print('# Motions and their derivatives in 40 digits, printed by sensitivity.py. Each line: model n k np t p[np] y0[2n] S0[2n x k]')
    print('# y[2n] S[2n x k]; columns of S: independent initial values, parameters.')
    for name, (equations, t, steps, x, p, place) in MODELS.items():
        x, p = [mpf(a) for a in x], [mpf(a) for a in p]
        d = len(x)

        def start(a):
            return place(a[:d], a[d:])

        def end(a):
            return place(motion(lambda y: equations(y, a[d:]), mpf(t), a[:d], steps), a[d:])

        S0, S = differences(start, x + p), differences(end, x + p)
        numbers = p + start(x + p) + rows(S0) + end(x + p) + rows(S)
        print(name, len(start(x + p)) // 2, d + len(p), len(p), t, *[nstr(a, 40) for a in numbers], flush=True)


main()
