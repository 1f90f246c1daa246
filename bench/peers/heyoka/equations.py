"""Has heyoka derive and compile one need of a chain, and writes its machine code as object files (run in heyoka's own environment).

    equations.py --model MODEL --size N --parameters FILE --need F --form sums --compact 0 --out DIR

The Lagrangian is given in one of two forms: velocities as running sums like the model's source, or multiplied out by hand. heyoka's
lagrangian() gives qdd, its diff_tensors() the derivatives. Leaves DIR/LANES.o for each width and DIR/info.json."""
import argparse
import json
import subprocess
import sys
from pathlib import Path

import heyoka as hy

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
import building  # noqa: E402


def names(letter, n):
    return [hy.expression(f"{letter}{i}") for i in range(n)]


def running_sums(terms):
    sums, total = [], hy.expression(0.0)
    for term in terms:
        total = total + term
        sums.append(total)
    return sums


def lagrangian_sums(angle, rate, gravity, mass, length):
    """Each mass with its velocity and height, added up along the chain."""
    vx = running_sums([l * hy.cos(a) * w for l, a, w in zip(length, angle, rate)])
    vy = running_sums([l * hy.sin(a) * w for l, a, w in zip(length, angle, rate)])
    drop = running_sums([l * hy.cos(a) for l, a in zip(length, angle)])
    return hy.sum([0.5 * m * (x * x + y * y) + m * gravity * d for m, x, y, d in zip(mass, vx, vy, drop)])


def lagrangian_product(angle, rate, gravity, mass, length):
    """One term for each pair of links: the mass below both, times cos of their angle, worked out by hand."""
    terms = []
    for i, (li, ai, wi) in enumerate(zip(length, angle, rate)):
        below = sum(mass[i:])
        terms += [0.5 * below * li * li * (wi * wi), below * gravity * li * hy.cos(ai)]
        terms += [below * li * lj * (hy.cos(ai) * hy.cos(aj) + hy.sin(ai) * hy.sin(aj)) * (wi * wj)
                  for lj, aj, wj in zip(length[:i], angle[:i], rate[:i])]
    return hy.sum(terms)


SMALL = 3  # links: up to here the Jacobian times w costs less than differentiating along w
FORMS = {"sums": lagrangian_sums, "product": lagrangian_product}


def derivatives(functions, variables):
    """The Jacobian, row by row."""
    return list(hy.diff_tensors(functions, variables, 1).jacobian.flatten())


def along(functions, variables, w):
    """The derivatives in the direction w."""
    if len(functions) <= SMALL:
        rows = hy.diff_tensors(functions, variables, 1).jacobian
        return [hy.sum([entry * step for entry, step in zip(row, w)]) for row in rows]
    step = hy.expression("step")
    moved = hy.subs(functions, {f"{y}": y + step * toward for y, toward in zip(variables, w)})
    return hy.subs(derivatives(moved, [step]), {"step": hy.expression(0.0)})


def equations(args):
    """(what to compute, its variables)"""
    q, qd = names("q", args.size), names("u", args.size)
    relative = args.model == "relative_chain"
    lagrangian = FORMS[args.form](running_sums(q) if relative else q, running_sums(qd) if relative else qd,
                                  *building.read_parameters(args.parameters))
    qdd = [rhs for _, rhs in hy.lagrangian(lagrangian, q, qd)[args.size:]]
    if args.need == "F":
        return qdd, q + qd
    if args.need == "J":
        return qdd + derivatives(qdd, q + qd), q + qd
    w = names("w", 2 * args.size)
    return qdd + along(qdd, q + qd, w), q + qd + w


def machine_code(function, compact):
    """{lanes: [object files' bytes]}, the symbol to call."""
    states = function.llvm_states
    if compact:
        return {1: (states.object_code, "cfunc.unstrided.batch_size_1"),
                function.batch_size: (states.object_code, f"cfunc.strided.batch_size_{function.batch_size}")}
    return {1: ([states[0].object_code], "cfunc"), function.batch_size: ([states[-1].object_code], "cfunc")}


def write_object(folder, lanes, modules, symbol, need):
    """Links the modules into one object file that shows nothing but the symbol, as heyoka_NEED."""
    parts = []
    for k, code in enumerate(modules):
        parts.append(folder / f"{lanes}-{k}.part.o")
        parts[-1].write_bytes(code)
    target = folder / f"{lanes}.o"
    subprocess.run(["ld", "-r", "-o", target, *parts], check=True)
    subprocess.run(["objcopy", f"--redefine-sym={symbol}=heyoka_{need}", f"--keep-global-symbol=heyoka_{need}", target], check=True)
    for part in parts:
        part.unlink()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--model", required=True)
    parser.add_argument("--size", type=int, required=True)
    parser.add_argument("--parameters", type=Path, required=True)
    parser.add_argument("--need", choices="FJV", required=True)
    parser.add_argument("--form", choices=FORMS, required=True)
    parser.add_argument("--compact", type=int, choices=(0, 1), required=True)
    parser.add_argument("--out", type=Path, required=True)
    args = parser.parse_args()

    outputs, variables = equations(args)
    function = hy.cfunc(outputs, variables, compact_mode=bool(args.compact), fast_math=True)
    codes = machine_code(function, args.compact)
    for lanes, (modules, symbol) in codes.items():
        write_object(args.out, lanes, modules, symbol, args.need)
    (args.out / "info.json").write_text(json.dumps({"lanes": list(codes), "tape": len(function.dc)}), encoding="utf-8")


if __name__ == "__main__":
    main()
