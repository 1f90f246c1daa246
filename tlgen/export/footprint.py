#!/usr/bin/env python3
"""What this export takes on Arm Cortex-M: flash, memory, worst-case stack and instructions of each need, into MANIFEST.

    footprint.py [--boards m4f,m3] [--keep FOLDER] [--paint]

Compiles with arm-none-eabi-gcc -O2 -fno-math-errno, links each need by itself with the startup of board/, and runs it under qemu-system-arm, whose
instruction counts repeat exactly. The stack is the deepest chain of calls, with the frames that gcc reports and, for the C library,
those that its instructions make. Fails where code allocates, calls itself, has a frame of unknown size, calls what nobody knows, or, in
an export of floats on a processor without doubles, computes in double. With cppcheck it also writes MISRA: each rule of MISRA-C:2012 that is not kept, how often, and
why. What is not installed is named in MANIFEST and left out.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
CC = "arm-none-eabi-gcc"
QEMU = "qemu-system-arm"
BOARDS = {  # flags, machine
    "m4f": ("-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16", "mps2-an386"),
    "m7": ("-mcpu=cortex-m7 -mthumb -mfloat-abi=hard -mfpu=fpv5-d16", "mps2-an500"),
    "m3": ("-mcpu=cortex-m3 -mthumb -mfloat-abi=soft", "mps2-an385"),
}
ALLOCATORS = {"malloc", "calloc", "realloc", "free", "_sbrk", "_malloc_r", "alloca"}

# Whom a call through a pointer can reach, by the name of the pointer where it stands in the source.
POINTERS = [  # name, whether function f of the model is one
    (r"rows|frame|dof|fits|jet", lambda f, name, model: f.startswith(model + "_tl.c:") and f.endswith("_" + name)),
    (r"energy|simulate|residual|linearise|tangent|parameters|acceleration|jacobian|directional|constrained",
     lambda f, name, model: f == model + "_" + name),
    (r"cholesky|qr|solve_lower(_transposed)?|solve_upper(_transposed)?|apply_qt?",
     lambda f, name, model: f in ("linalg_core.c:" + name, "eom_core_" + name)),
    (r"rhs", lambda f, name, model: f in ("main.c:rhs", "eom_rhs")),
    (r"correct|controlled|observe|root|handle|write|step|attempt|choose", lambda f, name, model: False),  # the example gives none
]

# Why a rule of MISRA-C:2012 is not kept, by rule, for the library's own code and what tlgen prints.
REASONS = {
    "1.4": "_Alignas of C11: the memory of a system holds all its types",
    "2.2": "cppcheck does not follow arrays into the inline kernels that read them",
    "2.3": "types of public headers that this model does not need",
    "2.4": "tags of public headers that this model does not need",
    "2.5": "macros of public headers that this model does not need",
    "5.7": "enumerations without a name in several functions, of which cppcheck thinks one name",
    "5.9": "static functions of two files may have one name",
    "8.7": "functions of a library are public, whether or not this example calls them",
    "8.9": "static memory and tables stand at file scope, where their size is seen",
    "8.14": "restrict, so that numbers stay in registers: eom/motion.h says that arguments do not overlap",
    "9.3": "{0}: C fills the rest of an array with zeros",
    "10.1": "shifts by a small count, which is an int; truth values combined by &, which takes no branch",
    "10.3": "counts, of which all are below 2^31, as size_t, and sizes as counts",
    "10.4": "counts and sizes in one expression, likewise",
    "10.8": "a count that becomes a number or a size, likewise",
    "11.5": "parameters of a model and the user of an integrator come as void pointers, so that one library serves all models",
    "11.8": "what is looked up inside of a step is computed at the first look, and kept in the integrator",
    "11.9": "a condition that cppcheck takes for a null pointer",
    "12.1": "products before sums, and comparisons before && and ||, as in mathematics",
    "12.3": "declarations and updates of two or three things that belong together",
    "13.3": "*table++ = value",
    "13.4": "two numbers that become one value",
    "14.1": "a loop over an array by its addresses, of which cppcheck thinks numbers",
    "14.2": "a search for the step that ends by a return",
    "14.4": "a pointer as a condition: it is null or not",
    "15.5": "a function returns where it knows the result, most of all at a failure",
    "15.6": "one short statement stands without braces",
    "16.4": "a switch over an enumeration has no default, so that compilers name what it has forgotten",
    "17.7": "memcpy and memset return what they were given",
    "17.8": "an argument that is the start of a search",
    "18.4": "a row of a matrix is its address plus an offset, as each header says of its arrays",
    "20.5": "a list macro ends where it was used",
    "20.7": "arguments that are types, names or initialisers",
    "20.10": "lists of names: one line of a list makes an enumerator and its text",
    "21.2": "a static function with the name of one of signal.h, which nobody includes",
    "21.6": "printf, where -DEXAMPLE_PRINT asks for it",
    "21.16": "memcmp of numbers: they are the same bits or not",
}


def run(command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options)


def fail(message):
    sys.exit("footprint.py: " + message)


class Manifest:
    def __init__(self):
        self.path = HERE / "MANIFEST"
        self.head = self.path.read_text().split("\nfootprint\n")[0]
        self.needs = re.search(r"^needs:(.*)$", self.head, re.M).group(1).split()
        self.model = re.search(r'^tlgen export, model "(.*)"$', self.head, re.M).group(1)
        self.real = re.search(r"^numbers: (.*)$", self.head, re.M).group(1)

    def write(self, lines):
        self.path.write_text(self.head + "\nfootprint\n" + "".join("  " + line + "\n" for line in lines))


class Calls:
    """The call graph of an image, from gcc's .ci files and, for what has none, from its instructions."""

    def __init__(self, folder, image, model):
        self.model = model
        self.frame, self.callees, self.unknown, self.faults, indirect = {}, {}, {}, [], []
        for ci in sorted(folder.glob("*.ci")):
            for kind, text in re.findall(r'^(node|edge): \{ (.*) \}$', ci.read_text(), re.M):
                field = dict(re.findall(r'(\w+): "((?:[^"\\]|\\.)*)"', text))
                if kind == "node":
                    size = re.search(r"(\d+) bytes \((\w+[^)]*)\)", field.get("label", ""))
                    if size:
                        self.frame[short(field["title"])] = int(size.group(1))
                        if size.group(2) != "static":
                            self.unknown[short(field["title"])] = f"{short(field['title'])} has a frame of unknown size"
                elif field["targetname"] == "__indirect_call":
                    indirect.append((short(field["sourcename"]), field["label"]))
                else:
                    self.callees.setdefault(short(field["sourcename"]), set()).add(short(field["targetname"]))
        self.linked = {line.split()[-1] for line in run(["arm-none-eabi-nm", image]).stdout.splitlines() if " T " in line or " t " in line or " W " in line}
        self.read_instructions(image)
        known = set(self.frame)
        for source, place in indirect:
            self.resolve(source, place, known)

    def read_instructions(self, image):
        """Frames and calls of the C library's functions."""
        name = None
        frames = {}
        for line in run(["arm-none-eabi-objdump", "-d", "--no-show-raw-insn", image]).stdout.splitlines():
            start = re.match(r"[0-9a-f]+ <(.*)>:", line)
            if start:
                name = start.group(1)
                continue
            if name is None or short(name) in self.frame:
                continue
            size = frames.setdefault(name, 0)
            pushed = re.search(r"\b(push|stmdb\s+sp!,)\S*\s*\{(.*)\}", line)
            floats = re.search(r"\bvpush\s*\{(.*)\}", line)
            room = re.search(r"\bsub(?:\.w|w)?\s+sp,(?:\s*sp,)?\s*#(\d+)", line)
            stored = re.search(r"\bstr(?:\.w|d)?\s.*\[sp, #-(\d+)\]!", line)
            call = re.search(r"\b(?:bl|b|b\.w|b\.n)\s+[0-9a-f]+ <([^+>]*)>", line)
            if floats:
                size += registers(floats.group(1)) * (8 if "d" in floats.group(1) else 4)
            elif pushed:
                size += registers(pushed.group(2)) * 4
            elif room or stored:
                size += int((room or stored).group(1))
            if call and call.group(1) != name:
                self.callees.setdefault(name, set()).add(call.group(1))
            frames[name] = size
        self.frame.update({n: s for n, s in frames.items() if n not in self.frame})

    def resolve(self, source, label, known):
        file, line, column = label.rsplit(":", 2)
        path = Path(file) if Path(file).is_absolute() else HERE / file
        text = path.read_text().splitlines()[int(line) - 1]
        before = re.findall(r"(\w+)\s*\(", text[max(0, int(column) - 40):])
        at = text[int(column) - 1:]
        name = re.match(r"[\w\->.\[\]*()]*?(\w+)\s*\(", at)
        candidates = [name.group(1)] if name else []
        candidates += before
        for candidate in candidates:
            for pattern, reaches in POINTERS:
                if re.fullmatch(pattern, candidate):
                    for f in known:
                        if reaches(f, candidate, self.model):
                            self.callees.setdefault(source, set()).add(f)
                    return
        self.unknown[source] = f"{source} calls somebody unknown at {file}:{line}: {text.strip()}"

    def worst(self, root, chain=()):
        """Bytes of stack, and the chain of calls that takes them."""
        if root in chain:
            self.faults.append("recursion: " + " > ".join(chain[chain.index(root):] + (root,)))
            return 0, chain
        if root in self.unknown:
            self.faults.append(self.unknown[root])
        deepest, way = 0, chain + (root,)
        for callee in sorted(self.callees.get(root, ())):
            if callee.split(":")[-1].split(".")[0] not in self.linked and callee not in self.linked and callee.split(":")[-1] not in self.linked:
                continue
            bytes_, path = self.worst(callee, chain + (root,))
            if bytes_ > deepest:
                deepest, way = bytes_, path
        return self.frame.get(root, 0) + deepest, way


def short(title):
    """A function's name; static ones as file:name."""
    file, _, name = title.rpartition(":")
    return Path(file).name + ":" + name if file else name


def registers(text):
    count = 0
    for part in text.split(","):
        ends = re.findall(r"(\d+)", part)
        count += int(ends[1]) - int(ends[0]) + 1 if "-" in part else 1
    return count


def sources():
    return sorted(HERE.glob("*.c")) + sorted((HERE / "src").glob("*.c"))


def compile_all(board, folder):
    flags = BOARDS[board][0].split()
    common = [CC, *flags, "-std=c11", "-O2", "-fno-math-errno", "-DNDEBUG", "-DEXAMPLE_WITHOUT_MAIN", "-ffunction-sections", "-fdata-sections",
              "-fstack-usage", "-fcallgraph-info=su", "-Wdouble-promotion", "-Wfloat-conversion", "-Wvla", "-Werror", "-I.", "-Iinclude"]
    for source in sources():
        made = run(common + ["-c", str(source.relative_to(HERE)), "-o", str(folder / (source.stem + ".o"))], cwd=HERE)
        if made.returncode:
            fail(made.stderr)
    return common


def link(need, folder, common, image, *more):
    return run(common + [f"-DNEED=example_{need}", *more, "board/board.c", *map(str, sorted(folder.glob("*.o"))), "-nostartfiles", "-T",
                         "board/board.ld", "-Wl,--gc-sections", "-lm", "-o", str(image)], cwd=HERE)


def start(board, image):
    """What the image says, by word: numbers."""
    said = run([QEMU, "-machine", BOARDS[board][1], "-nographic", "-monitor", "none", "-serial", "none", "-icount", "shift=6",
                "-semihosting-config", "enable=on,target=native", "-kernel", str(image)], timeout=120)
    told = dict(re.findall(r"^(\w+) (\d+)$", said.stdout + said.stderr, re.M))
    if said.returncode or "status" not in told:
        fail(f"{board}, {image.stem}: the board stopped with {said.returncode}: {said.stdout}{said.stderr}")
    return told


def paint(board, need, folder, common, computed):
    """The stack that a run really takes, of which what was computed is a bound."""
    image = folder / f"{need}-painted.elf"
    made = link(need, folder, common, image, "-DBOARD_STACK")
    if made.returncode:
        fail(made.stderr)
    taken = int(start(board, image)["stack"])
    if not 0 < taken <= computed:
        fail(f"{board}, {need}: a run takes {taken} bytes of stack, of {computed} by its calls")
    print(f"stack of {board}, {need}: {taken} bytes, of {computed} by its calls")


def measure(board, need, manifest, folder, common, painted):
    image = folder / f"{need}.elf"
    made = link(need, folder, common, image)
    if "_sbrk" in made.stderr:
        fail(f"{board}, {need}: the image allocates: the C library asks for _sbrk")
    if made.returncode:
        fail(made.stderr)
    text, data, bss = map(int, run(["arm-none-eabi-size", image]).stdout.splitlines()[1].split()[:3])
    calls = Calls(folder, image, manifest.model)
    stack, chain = calls.worst("example_" + need)
    for name in sorted(calls.linked & ALLOCATORS):
        calls.faults.append("the image allocates: " + name)
    if manifest.real == "float" and "m7" != board:
        for name in sorted(n for n in calls.linked if re.fullmatch(r"__aeabi_(d\w+|\w+2d)", n)):
            calls.faults.append("arithmetic in double: " + name)
    if calls.faults:
        fail(f"{board}, {need}:\n  " + "\n  ".join(sorted(set(calls.faults))))
    instructions, status = "not run: no " + QEMU, "-"
    if shutil.which(QEMU):
        told = start(board, image)
        if painted:
            paint(board, need, folder, common, stack)
        instructions, status = told.get("instructions", "-"), told["status"]
    return f"{board:5} {need:10} {text + data:7} {data + bss:6} {stack:6} {instructions:>9} {status:>6}   {' > '.join(c.split(':')[-1] for c in chain)}"


def misra():
    if not shutil.which("cppcheck"):
        return ["MISRA: no cppcheck here"]
    checked = run(["cppcheck", "--addon=misra", "--std=c11", "-DNDEBUG", "-DEXAMPLE_WITHOUT_MAIN", "-I.", "-Iinclude", "--suppress=*:*/board/*",
                   "-q", "--template={file}:{line} {id}", *[str(s.relative_to(HERE)) for s in sources()]], cwd=HERE)
    found = {}
    for place, rule in re.findall(r"^(\S+) misra-c2012-([\d.]+)$", checked.stderr, re.M):
        found.setdefault(rule, []).append(place)
    order = sorted(found, key=lambda r: [int(x) for x in r.split(".")])
    unknown = [r for r in order if r not in REASONS]
    lines = ["MISRA-C:2012, as cppcheck's addon sees it: rules that are not kept, places, the first of them, and why.", ""]
    lines += [f"{r:6} {len(found[r]):5}  {found[r][0]:36} {REASONS.get(r, 'NOT LOOKED AT: of the model itself, or new')}" for r in order]
    (HERE / "MISRA").write_text("\n".join(lines) + "\n")
    return [f"MISRA: {len(order)} rules are not kept, {len(unknown)} of them nobody has looked at: see MISRA"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--boards", default=",".join(BOARDS))
    parser.add_argument("--keep", help="a folder for objects and images")
    parser.add_argument("--paint", action="store_true", help="run each need with a painted stack too, and fail where it takes more than computed")
    parser.add_argument("--no-misra", action="store_true", help="leave cppcheck out, which takes longer than all else")
    given = parser.parse_args()
    manifest = Manifest()
    boards = given.boards.split(",")
    if any(b not in BOARDS for b in boards):
        fail("the boards are " + ", ".join(BOARDS))
    if not shutil.which(CC):
        manifest.write([f"not measured: no {CC} here"])
        return
    version = run([CC, "--version"]).stdout.splitlines()[0]
    lines = [version + ", -O2 -fno-math-errno; bytes, with the example's memory and the C library's part; instructions of one call",
             "board need         flash    RAM  stack instructions status   deepest calls"]
    with tempfile.TemporaryDirectory() as temporary:
        for board in boards:
            folder = Path(given.keep or temporary) / board
            folder.mkdir(parents=True, exist_ok=True)
            common = compile_all(board, folder)
            lines += [measure(board, need, manifest, folder, common, given.paint) for need in manifest.needs]
    if not given.no_misra:
        lines += misra()
    manifest.write(lines)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
