#!/usr/bin/env python3
"""Looks at what the firmware of examples/firmware has printed; exits with 1 and the place where something is not as it must be.

    firmware.py ends RUN.csv POLES          the poles stand at the end, and every status is the expected one
    firmware.py near RUN.csv HOST.csv       the motion is that of the host's build, within the bounds below
    firmware.py states RUN.csv              prints push and state of each row, for the program `derivatives`
    firmware.py same RUN.csv DERIVATIVES    the derivatives in each row are those of the host's build at the same state
    firmware.py random COUNT SEED POLES     prints random pushes and states that are numbers in single precision
    firmware.py precision FLOAT DOUBLE      prints and bounds the error of single precision, in parts of its rounding times the condition
"""
import math
import random
import struct
import sys

# In units of the last place of the largest number of an array, as two C libraries differ in the last bits of a sine; the second, of the
# linearisation and of more than two coordinates, whose numbers are differences, times the condition of the mass matrix.
MOST_ULP, MOST_ULP_BY_CONDITION = 4, 1
UPRIGHT, CENTRED = 0.03, 0.1  # rad, m: at the end; what sensors resolve moves the machine by some thousandths
# From a host: coordinates m and rad, then velocities. Sensors round to whole counts, so that the last bit of a sine sometimes moves a
# measurement by one (1e-4 m, 1e-3 rad), which the controller answers; the swing carries that on.
NEAR = {"coordinate": 1e-3, "velocity": 2e-2}
MOST_FLOAT = 2  # roundings times condition


def fail(text):
    sys.exit("firmware.py: " + text)


def table(path):
    """Rows by column name, and what the last lines say."""
    lines = open(path).read().splitlines()
    names = lines[0].split(",")
    rows = [dict(zip(names, line.split(","))) for line in lines[1:] if not line.startswith("#")]
    said = dict(line[2:].rsplit(" ", 1) for line in lines if line.startswith("# "))
    if len(rows) < 50 or any(len(row) != len(names) for row in rows):
        fail(f"{path}: too few rows, or too short ones")
    return names, rows, said


def numbers(row, kind):
    return [float(row[n]) for n in row if n.startswith(kind) and n[len(kind):].isdigit()]


def from_bits(digits):
    return struct.unpack(">f" if len(digits) == 8 else ">d", bytes.fromhex(digits))[0]


def bits(row, kinds):
    return [from_bits(row[n]) for kind in kinds for n in row if n.rstrip("0123456789") == kind + "_bits"]


def precision_of(row):
    return 24 if len(row["push_bits"]) == 8 else 53


def ulp(x, digits):
    return math.ldexp(1.0, max(math.frexp(x)[1], -120) - digits)


def upright(row):
    n = len(numbers(row, "measured"))
    y = numbers(row, "y")
    return abs(y[0]) < CENTRED and all(abs(math.remainder(angle, 2 * math.pi)) < UPRIGHT for angle in y[1:n])


def ends(path, poles):
    names, rows, said = table(path)
    expected = {"status": "0", "without mass, minus status": "2", "without mass, push is zero": "1"}
    for name, value in expected.items():
        if said.get(name) != value:
            fail(f"{path}: {name}: {said.get(name)}, expected {value}")
    if poles == 1 and (rows[0]["mode"] != "swing" or abs(numbers(rows[0], "y")[1]) < 2.5):
        fail(f"{path}: the pole does not hang at the start")
    for row in rows[-len(rows) // 8:]:
        if row["mode"] != "hold" or not upright(row):
            fail(f"{path}: at {row['ms']} ms the poles do not stand: {numbers(row, 'y')}")


def near(path, host):
    worst = {"coordinate": 0.0, "velocity": 0.0}
    for row, other in zip(table(path)[1], table(host)[1], strict=True):
        y, z = numbers(row, "y"), numbers(other, "y")
        for i, (a, b) in enumerate(zip(y, z)):
            kind = "coordinate" if i < len(y) // 2 else "velocity"
            worst[kind] = max(worst[kind], abs(a - b))
            if not abs(a - b) <= NEAR[kind]:
                fail(f"{path}: at {row['ms']} ms y{i} is {a}, on the host {b}")
    print(", ".join(f"largest difference of a {kind}: {x:.2g}" for kind, x in worst.items()))


def states(path):
    for row in table(path)[1]:
        print(*(x.hex() for x in bits(row, ["push", "y"])))


def derivatives(path):
    return [[float.fromhex(x) for x in line.split()] for line in open(path)]


def same(path, other):
    worst = {}
    for row, host in zip(table(path)[1], derivatives(other), strict=True):
        at = 0
        for kind in ("qdd", "qdd_y", "qdd_push"):
            board = bits(row, [kind])
            expected = host[at:at + len(board)]
            at += len(board)
            unit, most = ulp(max(map(abs, expected)), precision_of(row)), MOST_ULP
            if kind == "qdd_y" or len(host) > 15:
                unit, most = unit * host[-1], MOST_ULP_BY_CONDITION
            away = max(abs(a - b) for a, b in zip(board, expected, strict=True)) / unit
            worst[kind] = max(worst.get(kind, 0.0), away)
            if not away <= most:
                fail(f"{path}: at {row['ms']} ms {kind} is {board}, on the host {expected}: {away:.3g} of {most}")
    print(", ".join(f"largest difference of {kind}: {away:.2g}" for kind, away in worst.items()))


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def print_random(count, seed, poles):
    draw = random.Random(seed)
    for _ in range(count):
        y = [draw.uniform(-1, 1)] + [draw.uniform(-math.pi, math.pi) for _ in range(poles)]
        y += [draw.uniform(-2, 2)] + [draw.uniform(-8, 8) for _ in range(poles)]
        print(*(single(x).hex() for x in [draw.uniform(-20, 20)] + y))


def compare_precision(single_path, double_path):
    found = {"accelerations": [], "linearisation": []}
    for a, b in zip(derivatives(single_path), derivatives(double_path), strict=True):
        n = {1 + 2 + 8 + 2: 2, 1 + 3 + 18 + 3: 3}[len(b)]
        for kind, part in (("accelerations", slice(0, n)), ("linearisation", slice(n, len(b) - 1))):
            unit = ulp(max(abs(x) for x in b[part]), 24) * b[-1]
            found[kind].append(max(abs(x - y) for x, y in zip(a[part], b[part])) / unit)
    for kind, errors in found.items():
        errors.sort()
        print(f"{kind}: {len(errors)} states, error in ulp times condition: median {errors[len(errors) // 2]:.2g}, largest {errors[-1]:.2g}")
        if not errors[-1] <= MOST_FLOAT:
            fail(f"{kind}: more than {MOST_FLOAT} ulp times condition")


def main():
    command, *given = sys.argv[1:]
    if command == "ends":
        ends(given[0], int(given[1]))
    elif command == "near":
        near(*given)
    elif command == "states":
        states(*given)
    elif command == "same":
        same(*given)
    elif command == "random":
        print_random(*map(int, given))
    elif command == "precision":
        compare_precision(*given)
    else:
        fail("no command " + command)


if __name__ == "__main__":
    main()
