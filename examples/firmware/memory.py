#!/usr/bin/env python3
"""What an image of the firmware takes: prints flash, memory, worst-case stack in bytes, and the chain of calls that the stack is for.

    memory.py PROGRAM EXPORT     an image for a board, with PROGRAM.calls beside it, and the export that it was made of

Looks with the export's footprint.py. Fails where the image allocates, a function calls itself, has a frame of unknown size, or calls what
nobody knows, and where an image in single precision computes in double.
"""
import re
import sys
from pathlib import Path

program, export = Path(sys.argv[1]), Path(sys.argv[2]).resolve()
sys.path.insert(0, str(export))
sys.dont_write_bytecode = True
import footprint  # noqa: E402

# Whom the firmware's own pointers reach, by their names.
REACHED = {"rhs": ["loop.c:rhs"], "wrong": ["main.c:lose_mass", "main.c:tell_too_much", "main.c:tell_nothing"]}
for pointer, functions in REACHED.items():
    footprint.POINTERS.insert(0, (pointer, lambda f, name, model: f in REACHED[name]))


def main():
    model = footprint.Manifest()
    calls = footprint.Calls(Path(str(program) + ".calls"), program, model.model)
    stack, chain = calls.worst("board_reset")
    calls.faults += ["allocates: " + name for name in calls.linked & footprint.ALLOCATORS]
    if model.real == "float" and "m7" not in program.name:
        calls.faults += ["in double: " + name for name in calls.linked if re.fullmatch(r"__aeabi_(d\w+|\w+2d)", name)]
    if calls.faults:
        sys.exit(f"memory.py: {program}:\n  " + "\n  ".join(sorted(set(calls.faults))))
    text, data, bss = map(int, footprint.run(["arm-none-eabi-size", program]).stdout.splitlines()[1].split()[:3])
    print(text + data, data + bss, stack, " > ".join(c.split(":")[-1] for c in chain))


main()
