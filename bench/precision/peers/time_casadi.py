"""Times CasADi with CVODES, and scipy's DOP853, on the scenes that they can do, both with right-hand sides that CasADi derived and gcc
compiled (run in CasADi's environment): time_casadi.py [--quick] casadi|scipy FOLDER < SCENES."""
import ctypes
import os
import subprocess
import sys
import time
from pathlib import Path

import casadi as ca
import numpy

import equations
import timing

FLAGS = ["-O3", "-march=native", "-ffp-contract=fast", "-fno-math-errno"]
STIFF = {"flyball", "spring"}
MOST_STEPS = 300000
TRIAL = 1e-8


def dense_ldl(M, B):
    """M^-1 B by M = L D L' on scalars, as a user would who knows that M is positive definite."""
    n = M.shape[0]
    L, d = ca.SX.eye(n), []
    for j in range(n):
        d.append(M[j, j] - sum(L[j, k] * L[j, k] * d[k] for k in range(j)))
        for i in range(j + 1, n):
            L[i, j] = (M[i, j] - sum(L[i, k] * L[j, k] * d[k] for k in range(j))) / d[j]
    columns = []
    for c in range(B.shape[1]):
        x = [B[i, c] for i in range(n)]
        for i in range(n):
            x[i] = x[i] - sum(L[i, k] * x[k] for k in range(i))
        x = [x[i] / d[i] for i in range(n)]
        for i in reversed(range(n)):
            x[i] = x[i] - sum(L[k, i] * x[k] for k in range(i + 1, n))
        columns.append(ca.vertcat(*x))
    return ca.horzcat(*columns)


def right_hand_side(model, n):
    """f(y), y = (q,qd), from the Lagrangian; constraints by their multipliers."""
    y = ca.SX.sym("y", 2 * n)
    q, qd = ca.vertsplit(y[:n]), ca.vertsplit(y[n:])
    Q, V = ca.SX.sym("q", n), ca.SX.sym("qd", n)
    parts = ca.vertsplit(Q), ca.vertsplit(V)
    L = model.lagrangian(ca, *parts)
    momentum = ca.gradient(L, V)
    M = ca.densify(ca.hessian(L, V)[0])
    force = ca.densify(ca.gradient(L, Q) - ca.jtimes(momentum, Q, V)) + (ca.DM(model.force) if model.force else 0)
    if model.dissipation:
        force = force - ca.gradient(model.dissipation(ca, *parts), V)
    if model.loops:
        phi = ca.vertcat(*model.loops(ca, parts[0]))
        A = ca.jacobian(phi, Q)
        b = -ca.jtimes(ca.jtimes(phi, Q, V), Q, V)
        solved = dense_ldl(M, ca.horzcat(force, ca.densify(A.T)))
        free, back = solved[:, 0], solved[:, 1:]
        qdd = free + back @ dense_ldl(ca.densify(A @ back), b - A @ free)
    else:
        qdd = dense_ldl(M, force)
    ydot = ca.vertcat(V, qdd)
    f = ca.Function("f", [Q, V], [ydot])
    return ca.Function("rhs", [y], [ca.cse(f(ca.vertcat(*q), ca.vertcat(*qd)))])


def compiled(scene, form, model, folder):
    """The right-hand side, its library with its Jacobian, and the seconds that it took."""
    start = time.monotonic()
    name = f"{scene['scene']}{form}"
    f = right_hand_side(model, len(scene["q"]))
    here = os.getcwd()
    os.chdir(folder)
    generator = ca.CodeGenerator(f"{name}.c")
    generator.add(f)
    generator.add(f.jacobian())
    generator.generate()
    subprocess.run(["gcc", *FLAGS, "-shared", "-fPIC", f"{name}.c", "-o", f"{name}.so", "-lm"], check=True)
    os.chdir(here)
    return f, folder / f"{name}.so", time.monotonic() - start


def print_rows(scene, contender, method, evaluate, quick, tightest=16):
    """evaluate(tolerance) gives the run of one setting: a function that returns (steps, evaluations, state), or None where it fails."""
    for tolerance in timing.tolerances(quick, tightest=tightest):
        run = evaluate(tolerance)
        try:
            least, median, (steps, evaluations, state) = timing.repeat(run, quick)
        except RuntimeError:
            continue
        timing.row(scene, contender, method, f"tolerance {tolerance:.0e}", least, median, steps, evaluations, state)
        if least > timing.MOST_SECONDS[quick]:
            break


# ---- CasADi's integrator ----

def cvodes(scene, f, stiff):
    """By f: CasADi's own function, which it interprets, or the compiled one."""
    start = ca.DM(scene["q"] + scene["qd"])
    y = f.sx_in(0) if f.is_a("SXFunction") else ca.MX.sym("y", start.shape[0])
    problem = {"x": y, "ode": f(y)}
    scheme = {"linear_multistep_method": "bdf", "nonlinear_solver_iteration": "newton"} if stiff else \
        {"linear_multistep_method": "adams", "nonlinear_solver_iteration": "functional"}

    def evaluate(tolerance):
        options = {"reltol": tolerance, "abstol": tolerance, "max_num_steps": MOST_STEPS, "show_eval_warnings": False, **scheme}
        integrator = ca.integrator("motion", "cvodes", problem, 0.0, scene["t_end"], options)

        def run():
            end = integrator(x0=start)["xf"].full().ravel()
            stats = integrator.stats()
            return stats.get("nsteps", 0), stats.get("nfevals", 0), end
        return run
    return evaluate


def faster(scene, own, compiled_one, stiff, quick):
    """Whichever takes less at one tolerance, by name."""
    least = {}
    for name, f in (("interpreted", own), ("compiled", compiled_one)):
        try:
            least[name] = timing.repeat(cvodes(scene, f, stiff)(TRIAL), quick)[0]
        except RuntimeError:
            least[name] = float("inf")
    name = min(least, key=least.get)
    return name, own if name == "interpreted" else compiled_one


# ---- scipy's ----

def dop853(scene, library):
    import scipy.integrate
    lib = ctypes.CDLL(str(library))
    count = 2 * len(scene["q"])
    result = numpy.empty(count)
    inputs, outputs = (ctypes.c_void_p * 8)(), (ctypes.c_void_p * 8)(result.ctypes.data_as(ctypes.c_void_p))
    sizes = [ctypes.c_longlong() for _ in range(4)]
    lib.rhs_work(*map(ctypes.byref, sizes))
    integers, work = (ctypes.c_longlong * (sizes[2].value + 1))(), (ctypes.c_double * (sizes[3].value + 1))()
    lib.rhs.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int]

    def f(_, y):
        inputs[0] = y.ctypes.data
        lib.rhs(inputs, outputs, integers, work, 0)
        return result.copy()

    start = numpy.array(scene["q"] + scene["qd"])

    def evaluate(tolerance):
        def run():
            done = scipy.integrate.solve_ivp(f, (0.0, scene["t_end"]), start, method="DOP853", rtol=tolerance, atol=tolerance)
            return len(done.t) - 1, done.nfev, done.y[:, -1]
        return run
    return evaluate


def main():
    quick = "--quick" in sys.argv
    what, folder = sys.argv[-2], Path(sys.argv[-1])
    rhs = f"right-hand side from the Lagrangian (SX, LDL', cse), its C compiled by gcc {' '.join(FLAGS)}"
    if what == "casadi":
        timing.note(f"CasADi {ca.__version__} (PyPI): integrator cvodes, Adams with functional iteration, and BDF with Newton's iteration and "
                    f"CasADi's Jacobian; {rhs}, or interpreted by CasADi where that is faster at {TRIAL:g}")
    else:
        import scipy
        timing.note(f"scipy {scipy.__version__} (PyPI): solve_ivp, DOP853; {rhs}, called through ctypes")
    took, chosen = [], []
    for scene in timing.scenes(equations.FORMS):
        form, model = list(equations.FORMS[scene["scene"]].items())[-1]
        f, library, seconds = compiled(scene, form, model, folder)
        took.append(f"{scene['scene']} {seconds:.2g} s")
        if what == "scipy":
            print_rows(scene, "scipy", "DOP853", dop853(scene, library), quick, tightest=13)
            continue
        for method, stiff in (("CVODES Adams", False), ("CVODES BDF", True)):
            if stiff or scene["scene"] not in STIFF:
                name, best = faster(scene, f, ca.external("rhs", str(library)), stiff, quick)
                chosen.append(f"{scene['scene']}, {method}: {name}")
                print_rows(scene, "casadi", method, cvodes(scene, best, stiff), quick)
    timing.note(f"{what}: derived and compiled in: {'; '.join(took)}")
    if chosen:
        timing.note(f"casadi: {'; '.join(chosen)}")


if __name__ == "__main__":
    main()
