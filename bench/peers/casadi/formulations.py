"""The chain as a CasADi user would write it: from the Lagrangian to C for accelerations, Jacobian and one direction, in the formulations
that compete. Run inside the environment that `build` makes:
    formulations.py MODEL N PARAMETERS NEED FORMULATION FOLDER    writes FOLDER/generated.c"""
import os
import sys

import casadi as ca


def lagrangian(model, q, qd, gravity, masses, lengths):
    if model == "relative_chain":
        q, qd = ca.cumsum(q), ca.cumsum(qd)
    vx = vy = height = result = 0
    for k, (m, l) in enumerate(zip(masses, lengths)):
        vx += l * ca.cos(q[k]) * qd[k]
        vy += l * ca.sin(q[k]) * qd[k]
        height -= l * ca.cos(q[k])
        result += 0.5 * m * (vx * vx + vy * vy) - m * gravity * height
    return result


class Equations:
    """M qdd = Q and what follows from it, on scalars (SX)."""

    def __init__(self, n, energy, force=None, more=()):
        """energy(q, qd): the Lagrangian; force(q, qd): generalized forces; more: symbols of which both depend besides."""
        self.n, self.more = n, list(more)
        self.q, self.qd, self.w = ca.SX.sym("q", n), ca.SX.sym("qd", n), ca.SX.sym("w", 2 * n)
        self.y = ca.vertcat(self.q, self.qd)
        self.L = energy(self.q, self.qd)
        self.momentum = ca.gradient(self.L, self.qd)
        self.pull = ca.gradient(self.L, self.q) + (force(self.q, self.qd) if force else 0)
        self.M = ca.densify(ca.hessian(self.L, self.qd)[0])
        self.Q = ca.densify(self.pull - ca.jtimes(self.momentum, self.q, self.qd))

    def residual(self, qdd):
        """M qdd - Q by the chain rule along the motion."""
        return ca.jtimes(self.momentum, self.y, ca.vertcat(self.qd, qdd)) - self.pull

    def residual_derivative(self, qdd, directions):
        """d(M qdd - Q)/dy, or that times w, at fixed accelerations that are then replaced by qdd."""
        a = ca.SX.sym("a", self.n)
        r = self.residual(a)
        d = ca.jtimes(r, self.y, self.w) if directions else ca.jacobian(r, self.y)
        inputs = [self.q, self.qd, *self.more, self.w]
        return ca.densify(ca.Function("r_y", [*inputs, a], [d])(*inputs, qdd))


class as_written:
    """Inside, x*(1/y) stays: CasADi otherwise makes a division of each, where one reciprocal per pivot does."""

    def __enter__(self):
        self.before = ca.GlobalOptions.getSimplificationOnTheFly()
        ca.GlobalOptions.setSimplificationOnTheFly(False)

    def __exit__(self, *_):
        ca.GlobalOptions.setSimplificationOnTheFly(self.before)


def dense_ldl(M):
    """L' (unit, by rows) and the inverse pivots, for a dense M."""
    n = M.shape[0]
    w, inverse = [[M[i, j] for j in range(n)] for i in range(n)], []
    for i in range(n):
        inverse.append(1 / w[i][i])
        for p in range(i + 1, n):
            factor = w[i][p] * inverse[i]
            for j in range(p, n):
                w[p][j] -= factor * w[i][j]
        for j in range(i + 1, n):
            w[i][j] *= inverse[i]
    return w, inverse


def dense_solve(factors, b):
    """M^-1 b for one column."""
    w, inverse = factors
    n = len(inverse)
    x = [b[i] for i in range(n)]
    for i in range(n):
        for j in range(i + 1, n):
            x[j] -= w[i][j] * x[i]
    x = [x[i] * inverse[i] for i in range(n)]
    for i in reversed(range(n)):
        for j in range(i):
            x[j] -= w[j][i] * x[i]
    return ca.vertcat(*x)


def solver(kind, M):
    """B -> M^-1 B."""
    if kind == "qr":
        return lambda b: ca.solve(M, b)
    if kind == "minor":
        inverse = ca.inv_minor(M)
        return lambda b: inverse @ b
    with as_written():
        factors = dense_ldl(M)

    def solve(B):
        with as_written():
            return ca.horzcat(*(dense_solve(factors, B[:, k]) for k in range(B.shape[1])))
    return solve


def scalar_outputs(eq, need, derivative, kind, dense):
    """All of it on scalars. derivative: 'explicit' differentiates qdd through its solver, 'implicit' solves for the derivative."""
    solve = solver(kind, eq.M)
    qdd = solve(eq.Q)
    if need == "F":
        return [qdd]
    if derivative == "implicit":
        d = -solve(eq.residual_derivative(qdd, need == "V"))
    else:
        d = ca.jtimes(qdd, eq.y, eq.w) if need == "V" else ca.jacobian(qdd, eq.y)
    return [qdd, ca.densify(d) if dense else ca.sparsify(d)]


def mapped_function(eq, inputs):
    """J with the solver as a function of one column that a loop calls for each: short code for large n."""
    n = eq.n
    with as_written():
        w, inverse = dense_ldl(eq.M)
    packed = ca.vertcat(*(w[i][j] for i in range(n) for j in range(i + 1, n)), *inverse)
    f, b = ca.SX.sym("f", packed.shape[0]), ca.SX.sym("b", n)
    place, rows = 0, [[None] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1, n):
            rows[i][j], place = f[place], place + 1
    one = ca.Function("one", [f, b], [dense_solve((rows, [f[place + i] for i in range(n)]), b)])
    with as_written():
        first = ca.Function("first", [eq.q, eq.qd, *eq.more], ca.cse([packed, eq.Q]))
    a = ca.SX.sym("a", n)
    second = ca.Function("second", [eq.q, eq.qd, *eq.more, a], [ca.cse(ca.densify(-ca.jacobian(eq.residual(a), eq.y)))])
    given = [ca.MX.sym("q", n), ca.MX.sym("qd", n), *(ca.MX.sym(f"more{i}", *x.shape) for i, x in enumerate(eq.more))]
    factors, Q = first(*given)
    qdd = one(factors, Q)
    B = second(*given, qdd)
    J = one.map(2 * n)(ca.repmat(factors, 1, 2 * n), B) if inputs == "copies" else \
        one.map("one_map", "serial", 2 * n, [0], [])(factors, B)
    return ca.Function("evaluate", given, [qdd, J.T])


def function(eq, need, formulation, dense=True):
    derivative, kind, *rest = formulation.split(",")
    if derivative == "map":
        return mapped_function(eq, kind)
    outputs = scalar_outputs(eq, need, derivative, kind, dense)
    if need == "J":
        outputs[1] = outputs[1].T  # columns of it are rows of the result
    if "cse" in rest:
        with as_written():
            outputs = ca.cse(outputs)
    inputs = [eq.q, eq.qd, *eq.more] + ([eq.w] if need == "V" else [])
    return ca.Function("evaluate", inputs, outputs)


def main():
    model, n, parameters, need, formulation, folder = sys.argv[1:]
    with open(parameters, encoding="utf-8") as file:
        gravity, *links = file.read().splitlines()
    masses, lengths = zip(*(map(float, link.split()) for link in links))
    eq = Equations(int(n), lambda q, qd: lagrangian(model, q, qd, float(gravity), masses, lengths))
    os.chdir(folder)
    evaluate = function(eq, need, formulation)
    evaluate.generate("generated.c")
    with open("generated.c", "a", encoding="utf-8") as file:
        for what in ("arg", "res", "iw", "w"):
            file.write(f"enum {{ evaluate_SZ_{what.upper()} = {getattr(evaluate, 'sz_' + what)()} }};\n")


if __name__ == "__main__":
    main()
