"""The spectrum by heyoka's variational Taylor integrator (run in heyoka's own environment).

    variational.py LINKS T_END REPEATS TOLERANCE..

prints the rows of spectrum.h. Compilation is not timed."""
import math
import sys
import time

import heyoka as hy
import numpy as np

INTERVAL = 1.0  # s, between two QR
GRAVITY = 9.81


def pendulum(n):
    """The equations of motion that heyoka derives from the Lagrangian."""
    angle, rate = ([hy.expression(f"{letter}{i}") for i in range(n)] for letter in "qu")
    vx = vy = drop = lagrangian = hy.expression(0.0)
    for a, w in zip(angle, rate):
        vx, vy, drop = vx + hy.cos(a) * w, vy + hy.sin(a) * w, drop + hy.cos(a)
        lagrangian = lagrangian + 0.5 * (vx * vx + vy * vy) + GRAVITY * drop
    return hy.lagrangian(lagrangian, angle, rate)


def energy(y):
    q, u = np.split(y, 2)
    vx, vy, height = np.cumsum(np.cos(q) * u), np.cumsum(np.sin(q) * u), -np.cumsum(np.cos(q))
    return float(np.sum(0.5 * (vx**2 + vy**2) + GRAVITY * height))


def spectrum(integrator, n, t_end):
    """Sums of log R_ii, the largest energy error, steps."""
    start = np.zeros(2 * n)
    start[0] = math.radians(75.0)
    integrator.time = 0.0
    integrator.state[:2 * n] = start
    integrator.state[2 * n:] = np.eye(2 * n).flatten()
    rho, worst, steps, energy0 = np.zeros(2 * n), 0.0, 0, energy(start)
    for k in range(round(t_end / INTERVAL)):
        outcome = integrator.propagate_until((k + 1) * INTERVAL)
        steps += outcome[3]
        q, r = np.linalg.qr(integrator.state[2 * n:].reshape(2 * n, 2 * n))
        signs = np.sign(np.diag(r))
        rho += np.log(np.abs(np.diag(r)))
        integrator.state[2 * n:] = (q * signs).flatten()
        worst = max(worst, abs(energy(integrator.state[:2 * n]) - energy0))
    return rho, worst, steps


def main():
    n, t_end, repeats = int(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3])
    system = hy.var_ode_sys(pendulum(n), hy.var_args.vars, order=1)
    for tolerance in sys.argv[4:]:
        began = time.perf_counter()
        integrator = hy.taylor_adaptive(system, [0.0] * (2 * n), tol=float(tolerance), compact_mode=n > 2)
        built = time.perf_counter() - began
        print(f"heyoka {hy.__version__}: {built:.1f} s to compile", file=sys.stderr)
        least = math.inf
        for _ in range(repeats):
            began = time.process_time()
            rho, worst, steps = spectrum(integrator, n, t_end)
            least = min(least, time.process_time() - began)
        print(",".join([tolerance, f"{least:.6f}", f"{worst:.3e}", str(steps), *(f"{x / t_end:.6f}" for x in rho)]), flush=True)


if __name__ == "__main__":
    main()
