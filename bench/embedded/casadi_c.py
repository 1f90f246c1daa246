"""The plants as a CasADi user would write them: C for accelerations (simulate), with their Jacobian (linearise), and for a step of the
classical Runge-Kutta method (step). Run inside the environment that `run` makes:
    casadi_c.py PLANT NEED FORMULATION REAL FOLDER    writes FOLDER/generated.c and FOLDER/sizes.h"""
import os
import sys
from pathlib import Path

import casadi as ca

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "peers" / "casadi")]
import formulations  # noqa: E402
from models import PLANTS  # noqa: E402


def square(x):
    return x * x


def cart_pole(q, qd, t, p):
    half, inertia = 0.5 * p.pole_length, p.pole_mass * square(p.pole_length) * (1 / 12)
    speed2 = square(qd[0] + half * qd[1] * ca.cos(q[1])) + square(half * qd[1] * ca.sin(q[1]))
    kinetic = 0.5 * (p.cart_mass * square(qd[0]) + p.pole_mass * speed2 + inertia * square(qd[1]))
    force = ca.vertcat(p.push - p.cart_drag * qd[0], -p.hinge_drag * qd[1])
    return kinetic - p.pole_mass * p.gravity * half * ca.cos(q[1]), force


def furuta(q, qd, t, p):
    wy, wz = qd[0] * ca.sin(q[1]), qd[0] * ca.cos(q[1])
    twice = (p.arm_inertia + p.arm_mass * square(p.arm_com)) * square(qd[0])
    twice += p.pend_inertia_x * square(qd[1]) + p.pend_inertia_y * square(wy) + p.pend_inertia_z * square(wz)
    twice += p.pend_mass * (square(p.pend_com * wy) + square(p.arm_length * wz - p.pend_com * qd[1]) + square(p.arm_length * wy))
    current = (1.5 * ca.sin(4 * t) - p.motor_constant * qd[0]) / p.resistance
    force = ca.vertcat(p.motor_constant * current - p.arm_damping * qd[0], -p.pend_damping * qd[1])
    return 0.5 * twice - p.pend_mass * p.gravity * p.pend_com * ca.cos(q[1]), force


def double_cart_pole(q, qd, t, p):
    vx, vy, height = qd[0], 0, 0
    kinetic, potential = 0.5 * p.cart_mass * square(vx), 0
    for i in range(2):
        m, l, rate = p.pole_mass[i], p.pole_length[i], qd[i + 1]
        ux, uy, up = l * rate * ca.cos(q[i + 1]), -l * rate * ca.sin(q[i + 1]), l * ca.cos(q[i + 1])
        kinetic += 0.5 * m * (square(vx + 0.5 * ux) + square(vy + 0.5 * uy)) + m * square(l) * (1 / 24) * square(rate)
        potential += m * p.gravity * (height + 0.5 * up)
        vx, vy, height = vx + ux, vy + uy, height + up
    lower, upper = p.hinge_drag[0] * qd[1], p.hinge_drag[1] * (qd[2] - qd[1])
    return kinetic - potential, ca.vertcat(p.push - p.cart_drag * qd[0], upper - lower, -upper)


def chain(q, qd, t, p):
    links = zip(ca.vertsplit(p.mass), ca.vertsplit(p.length))
    return formulations.lagrangian("pendulum", q, qd, p.g, *zip(*links)), 0


class Parameters:
    """One symbol for all, and its parts by name."""

    def __init__(self, plant):
        self.all, at = ca.SX.sym("p", len(plant.numbers())), 0
        for name, value in plant.parameters.items():
            length = len(value) if isinstance(value, list) else 1
            setattr(self, name, self.all[at:at + length])
            at += length


def equations(name):
    plant = PLANTS[name]
    p, t, written = Parameters(plant), ca.SX.sym("t"), globals()[name]
    return formulations.Equations(plant.n, lambda q, qd: written(q, qd, t, p)[0], lambda q, qd: written(q, qd, t, p)[1], [t, p.all])


def step(eq, formulation):
    """y after a step of length h: the function of accelerations called four times, or written out."""
    how, solver, *rest = formulation.split(",")
    f = formulations.function(eq, "F", ",".join(["explicit", solver, *rest]))
    n = eq.n
    y, t, p, h = ca.MX.sym("y", 2 * n), ca.MX.sym("t"), ca.MX.sym("p", *eq.more[1].shape), ca.MX.sym("h")

    def slope(y, t):
        return ca.vertcat(y[n:], f(y[:n], y[n:], t, p))
    k1 = slope(y, t)
    k2 = slope(y + h / 2 * k1, t + h / 2)
    k3 = slope(y + h / 2 * k2, t + h / 2)
    k4 = slope(y + h * k3, t + h)
    whole = ca.Function("evaluate", [y, t, p, h], [y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)])
    return whole.expand("evaluate") if how == "expanded" else whole


def main():
    name, need, formulation, real, folder = sys.argv[1:]
    eq = equations(name)
    sparse = formulation.endswith(",sparse")
    formulation = formulation.removesuffix(",sparse")
    if need == "step":
        evaluate = step(eq, formulation)
    else:
        evaluate = formulations.function(eq, "F" if need == "simulate" else "J", formulation, not sparse)
    os.chdir(folder)
    generator = ca.CodeGenerator("generated.c", {"casadi_real": real, "casadi_int": "int"})
    generator.add(evaluate)
    generator.generate()
    with open("sizes.h", "w", encoding="utf-8") as file:
        for what in ("arg", "res", "iw", "w"):
            file.write(f"enum {{ SZ_{what.upper()} = {getattr(evaluate, 'sz_' + what)()} }};\n")
        if need == "linearise":  # of the transposed Jacobian: by columns, as C's rows
            column, row = evaluate.sparsity_out(1).get_triplet()[::-1]
            places = ", ".join(str(2 * eq.n * c + r) for c, r in zip(column, row))
            file.write(f"enum {{ NONZERO = {len(row)} }};\n#define PLACES {{{places}}}\n")


if __name__ == "__main__":
    main()
