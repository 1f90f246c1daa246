"""The benchmark's results: one row per timed build of a contender, and what the tables and plots take from them."""
import csv
import math
from collections import namedtuple

COLUMNS = ["contender", "model", "need", "N", "way", "compiler", "flags", "min_ns", "median_ns", "repeats", "check_error"]
Row = namedtuple("Row", COLUMNS)

OURS = "adjoint"  # the contender that all ratios refer to
OURS_OF_MANY = "adjoint-lanes"  # ours as well where states are independent
NEEDS = {"F": "accelerations", "J": "accelerations and their Jacobian", "V": "accelerations and one direction"}
WAYS = {"throughput": "independent states", "latency": "each state waits for the last result"}
TOLERANCE = 1e-9  # of the timer's check
EXPONENT_RANGE = (16, 64)


def read(path):
    """The rows of a CSV file; min_ns and median_ns are None where a check failed."""
    number = lambda text: float(text) if text else None
    with open(path, newline="", encoding="utf-8") as file:
        return [Row(**{**row, "N": int(row["N"]), "min_ns": number(row["min_ns"]), "median_ns": number(row["median_ns"]),
                       "repeats": int(row["repeats"]), "check_error": float(row["check_error"])}) for row in csv.DictReader(file)]


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(["" if value is None else value for value in row] for row in rows)


def unique(values):
    """The distinct values in their order."""
    return list(dict.fromkeys(values))


def best(rows):
    """The fastest build of each contender in each cell: {(model, need, way, N, contender): Row}."""
    found = {}
    for row in rows:
        key = (row.model, row.need, row.way, row.N, row.contender)
        if row.min_ns is not None and (key not in found or row.min_ns < found[key].min_ns):
            found[key] = row
    return found


def failures(rows):
    """The rows without a time."""
    return [row for row in rows if row.min_ns is None]


def exponent(times):
    """p of the least-squares fit time = c N^p over EXPONENT_RANGE, or None with fewer than two sizes. times: {N: ns}."""
    points = [(math.log(n), math.log(t)) for n, t in times.items() if EXPONENT_RANGE[0] <= n <= EXPONENT_RANGE[1]]
    if len(points) < 2:
        return None
    x, y = (sum(column) / len(points) for column in zip(*points))
    return sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a, b in points)
