#!/usr/bin/env python3
"""Names the functions that call themselves, or each other in a circle, by the .ci files that gcc writes with -fcallgraph-info.
    recursion.py FILE.."""
import re
import sys
from pathlib import Path


def main():
    callees = {}
    for name in sys.argv[1:]:
        for caller, callee in re.findall(r'^edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"', Path(name).read_text(encoding="utf-8"), re.M):
            callees.setdefault(caller, set()).add(callee)
    ends = [""]
    while ends:  # what calls nobody else, or is called by nobody, is in no circle; nor is what then calls nobody else, and so on
        called = {callee for to in callees.values() for callee in to}
        ends = [f for f in callees if f not in called or not callees[f] & callees.keys()]
        for f in ends:
            del callees[f]
    for f in sorted(callees):
        print("in a circle of calls: " + f)


if __name__ == "__main__":
    main()
