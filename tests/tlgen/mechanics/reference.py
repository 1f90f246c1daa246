#!/usr/bin/env python3
"""Prints what check.c compares a model with, from its physics in NAME.py, in 200-digit arithmetic; shares nothing with the library.

    reference.py NAME..          writes NAME.ref for each
    reference.py --check NAME    fails where NAME.ref is not what NAME.py says (first point, all but the costly highest derivatives)

NAME.py has n, points = [(q, qd, t)] or (q, qd, t, "why it is ill-conditioned"), lagrangian(q, qd, t), and where the model has them
force(q, qd, t), holonomic(q, t) and nonholonomic(q, qd, t), each of which returns a list. All derivatives are central differences: those
of the model's functions with steps 1e-40 (errors of 1e-80), those of the accelerations with steps 1e-20 (errors of 1e-40). Accelerations
and multipliers solve [M -A'; A 0] (qdd, lambda) = (Q, b) by elimination. The condition printed with each block is, with |.| the largest
number: for L and its derivatives D of order k, sum_i |x_i| |dD/dx_i| / |D| (for k = 3 that of k = 2), or 1 where that is less; for
accelerations and multipliers the condition of that matrix, or sum_i |y_i| |dqdd/dy_i| / |qdd| where that is more; for constraint rows as
for L. Needs mpmath.
"""
import importlib.util
import itertools
import os
import sys

try:
    from mpmath import inverse, lu_solve, matrix, mp, mpf, nstr
except ImportError:
    if os.path.exists('/etc/debian_version'):
        raise
    print('no mpmath here: skipped')
    sys.exit(77)

mp.dps = 200
STEP = mpf(10) ** -40   # differences of the model's functions
STEP2 = mpf(10) ** -20  # differences of the accelerations
DIGITS = 25             # printed: more than a double tells apart
NOISE = mpf(10) ** -30  # part of the largest number of its group below which a difference is zero
SAME = mpf(10) ** -20   # relative difference of two printed numbers that are the same


def load(name):
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), name + '.py')
    spec = importlib.util.spec_from_file_location('model_' + name, path)
    model = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(model)
    return model


class Differences:
    """Partial derivatives of f(x), a list of numbers, at x; values are kept, as the stencils share them."""

    def __init__(self, f, x, step):
        self.f, self.x, self.step, self.values = f, x, step, {}

    def value(self, offsets):
        if offsets not in self.values:
            self.values[offsets] = self.f([xi + self.step * k for xi, k in zip(self.x, offsets)])
        return self.values[offsets]

    def __call__(self, *index):
        rows = [mpf(0)] * len(self.value((0,) * len(self.x)))
        for signs in itertools.product((1, -1), repeat=len(index)):
            offsets, sign = [0] * len(self.x), 1
            for i, s in zip(index, signs):
                offsets[i] += s
                sign *= s
            rows = [r + sign * v for r, v in zip(rows, self.value(tuple(offsets)))]
        return [r / (2 * self.step) ** len(index) for r in rows]


class Model:
    def __init__(self, name):
        self.source = load(name)
        self.n = self.source.n
        self.points = [(p + ('',))[:4] for p in self.source.points]

    def lagrangian(self, x):
        return [mpf(self.source.lagrangian(x[:self.n], x[self.n:-1], x[-1]))]

    def rows(self, role, *arguments):
        return [mpf(r) for r in getattr(self.source, role)(*arguments)] if hasattr(self.source, role) else []

    def matrix_and_right_side(self, x):
        """[M -A'; A 0] and (Q, b) of M qdd = Q + A' lambda, A qdd = b."""
        n, q, qd, t = self.n, x[:self.n], x[self.n:-1], x[-1]
        d = Differences(self.lagrangian, x, STEP)
        force = self.rows('force', q, qd, t) or [mpf(0)] * n
        M = [[d(n + i, n + j)[0] for j in range(n)] for i in range(n)]
        Q = [force[i] + d(i)[0] - d(n + i, 2 * n)[0] - sum(d(n + i, j)[0] * qd[j] for j in range(n)) for i in range(n)]
        A, b = self.constraints(x)
        K = matrix(n + len(A), n + len(A))
        for i in range(n):
            for j in range(n):
                K[i, j] = M[i][j]
            for r in range(len(A)):
                K[i, n + r], K[n + r, i] = -A[r][i], A[r][i]
        return K, matrix(Q + b)

    def constraints(self, x):
        n, q, qd, t = self.n, x[:self.n], x[self.n:-1], x[-1]

        def along(s):  # (q, t) after a time s at constant velocity
            return [qi + s * vi for qi, vi in zip(q, qd)], t + s

        phi = Differences(lambda x: self.rows('holonomic', x[:n], x[-1]), x, STEP)
        phi_s = Differences(lambda s: self.rows('holonomic', *along(s[0])), [mpf(0)], STEP)
        psi = Differences(lambda x: self.rows('nonholonomic', x[:n], x[n:-1], x[-1]), x, STEP)
        psi_s = Differences(lambda s: self.rows('nonholonomic', along(s[0])[0], qd, along(s[0])[1]), [mpf(0)], STEP)
        columns = [phi(i) + psi(n + i) for i in range(n)]
        return [list(row) for row in zip(*columns)], [-b for b in phi_s(0, 0) + psi_s(0)]

    def constraint_rows(self, x):
        """phi, then psi."""
        n = self.n
        return self.rows('holonomic', x[:n], x[-1]) + self.rows('nonholonomic', x[:n], x[n:-1], x[-1])

    def accelerations(self, x):
        """qdd, then lambda."""
        return list(lu_solve(*self.matrix_and_right_side(x)))


def largest(numbers):
    return max((abs(v) for v in numbers), default=mpf(0))


def relative_growth(x, value, by_each):
    """sum_i |x_i| |dvalue/dx_i| / |value|, at least 1."""
    scale = largest(value)
    return max(mpf(1), sum(abs(xi) * largest(d) for xi, d in zip(x, by_each)) / scale) if scale else mpf(1)


def norm(a):
    return max(sum(abs(a[i, j]) for j in range(a.cols)) for i in range(a.rows))


def derivative_blocks(model, x, orders):
    """[name, condition, numbers] of L and its derivatives by (q, qd, t), indices in ascending order."""
    count, d, blocks = len(x), Differences(model.lagrangian, x, STEP), []
    indices = [list(itertools.combinations_with_replacement(range(count), k)) for k in range(orders + 1)]
    for name, index in zip(('L', 'gradient', 'hessian', 'third'), indices):
        numbers, order = [d(*i)[0] for i in index], len(index[0])
        if order < orders:
            condition = relative_growth(x, numbers, [[d(*i, v)[0] for i in index] for v in range(count)])
        blocks.append([name, condition, numbers])
    return blocks


def motion_blocks(model, x, with_jacobian):
    K, right = model.matrix_and_right_side(x)
    condition = norm(K) * norm(inverse(K))
    both = list(lu_solve(K, right))
    blocks = [['qdd', condition, both[:model.n]], ['lambda', condition, both[model.n:]]]
    if with_jacobian:
        d = Differences(model.accelerations, x, STEP2)
        columns = [d(i) for i in range(2 * model.n)]
        parts = (slice(0, model.n), slice(model.n, None))
        for name, part in zip(('qdd_y', 'lambda_y') if len(both) > model.n else ('qdd_y',), parts):
            blocks.append([name, condition, [derivative for row in zip(*(c[part] for c in columns)) for derivative in row]])
        for block, part in zip(blocks, parts + parts):
            block[1] = max(condition, relative_growth(x, both[part], [c[part] for c in columns]))
    rows = Differences(model.constraint_rows, x, STEP)
    if rows():
        blocks.append(['rows', relative_growth(x, rows(), [rows(i) for i in range(len(x))]), rows()])
    return blocks


def without_noise(blocks):
    scale = largest(v for block in blocks for v in block[2])
    return [[name, condition, [v if abs(v) > NOISE * scale else mpf(0) for v in numbers]] for name, condition, numbers in blocks]


def evaluate(model, point, whole=True):
    x = [mpf(v) for v in point[0] + point[1] + [point[2]]]
    return without_noise(derivative_blocks(model, x, 3 if whole else 2)) + without_noise(motion_blocks(model, x, whole))


def state_text(point):
    return ' '.join(repr(float(v)) for v in point[0] + point[1] + [point[2]])


def print_reference(name):
    model = Model(name)
    lines = [f'# Printed by reference.py from {name}.py.', f'n {model.n}', f'points {len(model.points)}']
    for point in model.points:
        lines += [f'point {point[3] or "generic"}', state_text(point)]
        for block, condition, numbers in evaluate(model, point):
            lines.append(f'{block} {len(numbers)} {nstr(condition, 3)}')
            lines += [nstr(v, DIGITS) if v else '0' for v in numbers]
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), name + '.ref')
    with open(path, 'w') as f:
        f.write('\n'.join(lines) + '\n')


def check_reference(name):
    """The first point of NAME.ref beside NAME.py; True where they agree."""
    model = Model(name)
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), name + '.ref')) as f:
        lines = f.read().splitlines()
    states = [line for before, line in zip(lines, lines[1:]) if before.startswith('point ')]
    if states != [state_text(p) for p in model.points]:
        print(f'{name}.ref: other points than in {name}.py: run reference.py {name}')
        return False
    second = next((i for i, line in enumerate(lines) if line.startswith('point ') and i > 3), len(lines))
    for block, _, numbers in evaluate(model, model.points[0], whole=False):
        start = next(i for i, line in enumerate(lines[:second]) if line.startswith(block + ' ')) + 1
        printed = [mpf(line) for line in lines[start:start + len(numbers)]]
        if largest(a - b for a, b in zip(numbers, printed)) > SAME * largest(numbers):
            print(f'{name}.ref: {block} of the first point is not what {name}.py says: run reference.py {name}')
            return False
    return True


if __name__ == '__main__':
    if sys.argv[1:2] == ['--check'] and len(sys.argv) == 3:
        sys.exit(0 if check_reference(sys.argv[2]) else 1)
    if len(sys.argv) < 2 or sys.argv[1].startswith('-'):
        sys.exit(__doc__)
    for model_name in sys.argv[1:]:
        print_reference(model_name)
