"""Times heyoka's Taylor integrator on the scenes that it can do (run in heyoka's environment): time_heyoka.py [--quick] < SCENES."""
import sys
import time

import heyoka as hy

import equations
import timing


TRIAL = 1e-8
EPSILON = 2.3e-16  # heyoka takes no smaller tolerance


def names(letter, n):
    return [hy.expression(f"{letter}{i}") for i in range(n)]


def eliminate(rows, columns):
    """rows x = columns by Gauss's elimination without pivoting, on expressions; both are changed."""
    n = len(rows)
    for k in range(n):
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            rows[i][k + 1:] = [a - factor * b for a, b in zip(rows[i][k + 1:], rows[k][k + 1:])]
            columns[i] = [a - factor * b for a, b in zip(columns[i], columns[k])]
    for k in reversed(range(n)):
        for i in range(k + 1, n):
            columns[k] = [a - rows[k][i] * b for a, b in zip(columns[k], columns[i])]
        columns[k] = [a / rows[k][k] for a in columns[k]]
    return columns


def gradient(function, variables):
    return [hy.diff(function, x) for x in variables]


def along(functions, variables, direction):
    return [hy.sum([hy.diff(f, x) * d for x, d in zip(variables, direction)]) for f in functions]


def accelerations(model, q, qd):
    """Of M qdd - A' lambda = Q, A qdd = b: lambda from A M^-1 A', then qdd."""
    L, phi = model.lagrangian(hy, q, qd), model.loops(hy, q) if model.loops else []
    momentum = gradient(L, qd)
    M = [gradient(p, qd) for p in momentum]
    force = model.force or [hy.expression(0.0)] * len(q)
    loss = gradient(model.dissipation(hy, q, qd), qd) if model.dissipation else [hy.expression(0.0)] * len(q)
    Q = [g - c + f - d for g, c, f, d in zip(gradient(L, q), along(momentum, q, qd), force, loss)]
    A = [gradient(row, q) for row in phi]
    b = [-x for x in along(along(phi, q, qd), q, qd)]
    solved = eliminate(M, [[Q[i], *(row[i] for row in A)] for i in range(len(q))])
    S = [[hy.sum([row[i] * solved[i][k] for i in range(len(q))]) for k in range(len(A) + 1)] for row in A]
    multipliers = eliminate([s[1:] for s in S], [[bk - s[0]] for bk, s in zip(b, S)])
    return [x[0] + hy.sum([c * m[0] for c, m in zip(x[1:], multipliers)]) if multipliers else x[0] for x in solved]


def system(model, n):
    """The equations of motion, by heyoka's own function where it has one for them."""
    q, qd = names("q", n), names("u", n)
    if model.loops or model.dissipation:
        return list(zip(q + qd, qd + accelerations(model, q, qd)))
    return hy.lagrangian(model.lagrangian(hy, q, qd), q, qd)


def measure(scene, motion, tolerance, compact, quick):
    """(tolerance, least, median, steps, state at the end), and the seconds that compilation took."""
    start_state, start = scene["q"] + scene["qd"], time.monotonic()
    integrator = hy.taylor_adaptive(motion, start_state, tol=max(tolerance, EPSILON), compact_mode=compact, fast_math=True)
    compiled = time.monotonic() - start

    def run():
        integrator.time, integrator.state[:] = 0.0, start_state
        return integrator.propagate_until(scene["t_end"])

    least, median, outcome = timing.repeat(run, quick)
    if outcome[0] != hy.taylor_outcome.time_limit:
        return None, compiled
    return (tolerance, least, median, outcome[3], integrator.state.copy()), compiled


def fastest(scene, quick):
    """The motion and the mode that take least at one tolerance, and their name."""
    found = None
    for form, model in equations.FORMS[scene["scene"]].items():
        motion = system(model, len(scene["q"]))
        for compact in (True,) if quick else (False, True):
            row, _ = measure(scene, motion, TRIAL, compact, quick)
            if row and (found is None or row[1] < found[0]):
                found = row[1], motion, compact, f"{form} {'compact' if compact else 'plain'}".strip()
    return found[1:]


def main():
    quick = "--quick" in sys.argv
    timing.note(f"heyoka {hy.__version__} (PyPI): taylor_adaptive of the Lagrangian's equations, fast_math; of the Lagrangian's forms, with and "
                f"without compact_mode, what is fastest at {TRIAL:g} stands for it; compilation, for each tolerance, is not in the times")
    chosen = []
    for scene in timing.scenes(equations.FORMS):
        motion, compact, name = fastest(scene, quick)
        most = 0.0
        for tolerance in timing.tolerances(quick, step=3, tightest=16):
            row, compiled = measure(scene, motion, tolerance, compact, quick)
            most = max(most, compiled)
            if row:
                timing.row(scene, "heyoka", "Taylor", f"tolerance {tolerance:.0e}", *row[1:4], 0, row[4])
            if row and row[1] > timing.MOST_SECONDS[quick]:
                break
        chosen.append(f"{scene['scene']} {name}, {most:.2g} s")
    timing.note(f"heyoka: the fastest form, and the longest compilation for one tolerance: {'; '.join(chosen)}")


if __name__ == "__main__":
    main()
