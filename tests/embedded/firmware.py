#!/usr/bin/env python3
"""Looks at what the firmware of examples/firmware has printed; exits with 1 and the place where something is not as it must be.

    firmware.py ends RUN.csv                the poles hang at the start and stand at the end, and every status is the expected one
    firmware.py same RUN.csv HOST.csv       a board's run is the host's to the bit: states, derivatives, pushes, statuses
    firmware.py table ONE.c OTHER.c         two tables of planned motions are the same but for what an optimum leaves open
    firmware.py planned TABLE.c             a motion from hanging to standing, with pushes that leave something to a regulator
    firmware.py random COUNT SEED POLES     prints random pushes and states that are numbers in single precision
    firmware.py precision FLOAT DOUBLE      prints and bounds the error of single precision, in parts of its rounding times the condition
"""
import math
import random
import re
import struct
import sys

UPRIGHT, CENTRED = 0.03, 0.1  # rad, m: at the end; what sensors resolve moves the machine by some thousandths
# Of the largest number of a kind: an optimum known to some parts in 1e9 of its cost is known to the root of that in its place.
MOST_TABLE = 3e-3
PLANNED_REST, PLANNED_PUSH = 0.1, 15  # m, rad, m/s, rad/s; N
FAULTS = {"without mass": 2, "infinite angle": 1, "no number": 1}  # minus their status
FAULT_STEPS = 20
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


def ulp(x, digits):
    return math.ldexp(1.0, max(math.frexp(x)[1], -120) - digits)


def upright(row):
    n = len(numbers(row, "measured"))
    y = numbers(row, "y")
    return abs(y[0]) < CENTRED and all(abs(math.remainder(angle, 2 * math.pi)) < UPRIGHT for angle in y[1:n])


def ends(path):
    _, rows, said = table(path)
    expected = {"status": "0"}
    for fault, status in FAULTS.items():
        expected |= {f"{fault}, minus status": str(status), f"{fault}, control steps with a status": str(FAULT_STEPS), f"{fault}, the poles stand": "1"}
    for name, value in expected.items():
        if said.get(name) != value:
            fail(f"{path}: {name}: {said.get(name)}, expected {value}")
    poles = len(numbers(rows[0], "measured")) - 1
    if rows[0]["mode"] == "hold" or any(abs(angle) < 2.9 for angle in numbers(rows[0], "y")[1:1 + poles]):
        fail(f"{path}: the poles do not hang at the start")
    for row in rows[-len(rows) // 10:]:
        if row["mode"] != "hold" or not upright(row):
            fail(f"{path}: at {row['ms']} ms the poles do not stand: {numbers(row, 'y')}")


def same(path, host):
    names, rows, said = table(path)
    _, others, host_said = table(host)
    for row, other in zip(rows, others, strict=True):
        for name in names:
            if name != "instructions" and row[name] != other[name]:
                fail(f"{path}: at {row['ms']} ms {name} is {row[name]}, on the host {other[name]}")
        if int(row["instructions"]) < 1000:
            fail(f"{path}: at {row['ms']} ms a control step of {row['instructions']} instructions")
    if {name: value for name, value in said.items() if "instructions" not in name} != host_said:
        fail(f"{path}: says {said}, the host {host_said}")


def knots(path):
    """The numbers of each knot: push, state, matrix."""
    text = open(path).read()
    return [[float(x) for x in re.findall(r"(-?[0-9.]+e[+-][0-9]+)f", knot)] for knot in re.findall(r"^  \{(.*?)\}\},$", text, re.M | re.S)]


def same_table(path, other):
    one, two = knots(path), knots(other)
    if len(one) < 50 or len(one) != len(two):
        fail(f"{path}: {len(one)} knots, in {other} {len(two)}")
    for i in range(len(one[0])):
        largest = max(abs(knot[i]) for knot in two)
        for k, (a, b) in enumerate(zip(one, two, strict=True)):
            if not abs(a[i] - b[i]) <= MOST_TABLE * largest:
                fail(f"{path}: number {i} of knot {k} is {a[i]}, in {other} {b[i]}, of {largest}")


def planned(path):
    motion = knots(path)
    first, last = motion[0][1:7], motion[-1][1:7]
    if len(motion) < 50 or first != [0, 3.14159265, 3.14159265, 0, 0, 0]:
        fail(f"{path}: {len(motion)} knots from {first}")
    if not max(map(abs, last)) < PLANNED_REST or not max(abs(knot[0]) for knot in motion) < PLANNED_PUSH:
        fail(f"{path}: ends at {last}, pushes {max(abs(knot[0]) for knot in motion)}")


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def print_random(count, seed, poles):
    draw = random.Random(seed)
    for _ in range(count):
        y = [draw.uniform(-1, 1)] + [draw.uniform(-math.pi, math.pi) for _ in range(poles)]
        y += [draw.uniform(-2, 2)] + [draw.uniform(-8, 8) for _ in range(poles)]
        print(*(single(x).hex() for x in [draw.uniform(-20, 20)] + y))


def derivatives(path):
    return [[float.fromhex(x) for x in line.split()] for line in open(path)]


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
        ends(given[0])
    elif command == "same":
        same(*given)
    elif command == "table":
        same_table(*given)
    elif command == "planned":
        planned(*given)
    elif command == "random":
        print_random(*map(int, given))
    elif command == "precision":
        compare_precision(*given)
    else:
        fail("no command " + command)


if __name__ == "__main__":
    main()
