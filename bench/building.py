"""What the contenders' build scripts share: their arguments, compilation by gcc and clang, and the lines that bench/run reads."""
import argparse
import hashlib
import json
import os
import shlex
import subprocess
import sys
import time
from pathlib import Path

BENCH = Path(__file__).resolve().parent
PROJECT = BENCH.parent

# The flags that design notes ask for with generated code: contraction, no errno, and no SLP vectoriser, which has been seen to go wrong on
# long straight-line code.
COMMON = ["-O3", "-march=native", "-ffp-contract=fast", "-fno-math-errno"]
COMPILERS = {"gcc": ["-fno-tree-slp-vectorize"], "clang-19": ["-fno-slp-vectorize"]}
WIDTHS = (256, 512)


def parse(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--out", type=Path, required=True, help="folder for what belongs to this case")
    parser.add_argument("--env", type=Path, required=True, help="folder for what all cases share")
    parser.add_argument("--model", required=True)
    parser.add_argument("--size", type=int, required=True)
    parser.add_argument("--parameters", type=Path, required=True, help="gravity, then a mass and a length per line")
    parser.add_argument("--needs", default="FJV")
    parser.add_argument("--seconds", type=float, default=120.0)
    parser.add_argument("--quick", action="store_true", help="one build is enough, and it need not be fast")
    return parser.parse_args()


def needs(args):
    """The needs that are asked for of a model that has them all."""
    return "F" if args.model == "cartesian_pendulum" else "FJV"


def read_parameters(path):
    """(gravity, masses, lengths)"""
    gravity, *links = path.read_text(encoding="utf-8").splitlines()
    masses, lengths = zip(*(map(float, link.split()) for link in links))
    return float(gravity), masses, lengths


def note(text):
    print(json.dumps({"note": text}), flush=True)


def absent(reason):
    """Ends the script: the contender cannot be had here."""
    print(reason, file=sys.stderr)
    sys.exit(77)


def version(compiler):
    full = subprocess.run([compiler, "-dumpfullversion" if compiler.startswith("gcc") else "-dumpversion"], text=True,
                          stdout=subprocess.PIPE, check=True).stdout.strip()
    return f"{compiler.split('-')[0]} {full}"


def code_bytes(path):
    """The size of the text section."""
    lines = subprocess.run(["size", path], text=True, stdout=subprocess.PIPE, check=True).stdout.splitlines()
    return int(lines[1].split()[0])


def fingerprint(command, sources):
    """Changes with the command and with the text of every file that may go into it."""
    digest = hashlib.sha256(shlex.join(map(str, command)).encode())
    for path in sources:
        digest.update(path.read_bytes())
    return digest.hexdigest()


def compile_object(output, compiler, flags, arguments, depends, seconds):
    """Compiles a shared object unless the one that is there was made by the same command from the same files. Returns the seconds that
    it took, or None where it did not end in time."""
    command = [compiler, *flags, "-shared", "-fPIC", "-fno-semantic-interposition", *arguments]
    stamp, now = output.with_suffix(".stamp"), fingerprint(command, depends)
    fresh = output.with_suffix(f".{os.getpid()}") # others may load the old one, or make the same
    if output.exists() and stamp.exists():
        was, took = stamp.read_text(encoding="utf-8").split()
        if was == now:
            return float(took)
    start = time.monotonic()
    try:
        subprocess.run([*command, "-o", fresh], check=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        fresh.unlink(missing_ok=True)
        return None
    took = time.monotonic() - start
    fresh.replace(output)
    stamp.write_text(f"{now} {took:.3f}\n", encoding="utf-8")
    return took


def offer(output, compiler, flags, **more):
    """Tells bench/run of an object."""
    print(json.dumps({"object": str(output), "compiler": version(compiler), "flags": shlex.join(flags), **more}), flush=True)


def build(args, name, compiler, flags, arguments, depends, **more):
    """Compiles and offers one object; says so where it takes too long."""
    output = args.out.resolve() / f"{name}.so"
    took = compile_object(output, compiler, flags, arguments, depends, args.seconds)
    if took is None:
        note(f"{args.model} N={args.size}: {compiler} {shlex.join(flags)} ({more.get('variant', name)}) not done in {args.seconds:.0f} s")
    else:
        more["seconds"] = more.get("seconds", 0.0) + took
        more["code_bytes"] = code_bytes(output)
        offer(output, compiler, flags, **more)


def installed(program):
    return any(os.access(Path(folder) / program, os.X_OK) for folder in os.get_exec_path())


def compilers(args):
    """Those of COMPILERS that are installed."""
    return [name for name in COMPILERS if installed(name)][:1 if args.quick else None]
