"""What the build scripts of the benchmark's peers share: their arguments, virtual environments, cached compilations, and answers.

A build script is called once per model and size and prints one JSON object a line:
  {"object": FILE, "variant": .., "compiler": .., "flags": .., "needs": ..}   a shared object that exports bench_open (bench/contender.h)
  {"note": ..}                                                             how the peer was built, its version, its limits
It ends with 77 where the peer cannot be had, with the reason as the last line on stderr.
"""

import argparse
import fcntl
import hashlib
import json
import os
import pathlib
import subprocess
import sys

PEERS = pathlib.Path(__file__).resolve().parent
BENCH = PEERS.parent
ABSENT = 77

# The compilers that compete for each contender, C and C++.
COMPILERS = {"gcc": ("gcc", "g++"), "clang": ("clang-19", "clang++-19")}
NATIVE = ["-O3", "-march=native", "-DNDEBUG"]


def arguments(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--out", type=pathlib.Path, required=True, help="an existing folder for this model and size")
    parser.add_argument("--env", type=pathlib.Path, required=True, help="a folder that all sizes share and that is kept")
    parser.add_argument("--model", required=True, choices=["pendulum", "relative_chain"])
    parser.add_argument("--size", type=int, required=True, help="number of coordinates")
    parser.add_argument("--parameters", type=pathlib.Path, required=True, help="gravity, then mass and length of each link")
    parser.add_argument("--needs", default="FJV")
    parser.add_argument("--seconds", type=float, default=60.0, help="about how long this call may take")
    args = parser.parse_args()
    args.out, args.env = args.out.resolve(), args.env.resolve()
    args.env.mkdir(parents=True, exist_ok=True)
    return args


def parameters(path):
    """gravity, masses, lengths."""
    numbers = [float(word) for word in path.read_text().split()]
    return numbers[0], numbers[1::2], numbers[2::2]


def absent(reason):
    print(reason, file=sys.stderr)
    sys.exit(ABSENT)


def note(text):
    print(json.dumps({"note": text}), flush=True)


def contender(path, variant, compiler, flags, needs):
    print(json.dumps({"object": str(path), "variant": variant, "compiler": compiler, "flags": flags, "needs": needs}), flush=True)


def run(command, **options):
    """The command's output; where it fails, its complaint goes to stderr and CalledProcessError is raised."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if done.returncode:
        sys.stderr.write(done.stdout[-4000:] + done.stderr[-4000:])
        done.check_returncode()
    return done.stdout


def environment(env, name, packages):
    """The Python of the virtual environment env/NAME-venv with these packages from PyPI; made where it is missing. Another call that makes
    it at the same time is waited for."""
    venv = env / f"{name}-venv"
    stamp, wanted = venv / "packages", " ".join(packages)
    with open(env / f"{name}.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (stamp.exists() and stamp.read_text() == wanted):
            try:
                run([sys.executable, "-m", "venv", "--clear", venv])
                run([venv / "bin/pip", "install", "--quiet", "--disable-pip-version-check", *packages])
            except subprocess.CalledProcessError:
                absent(f"{name}: pip cannot install {wanted}")
            stamp.write_text(wanted)
    return venv / "bin/python"


def site_packages(python):
    return pathlib.Path(run([python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"]).strip())


def version(python, package):
    return run([python, "-c", f"import importlib.metadata as m; print(m.version('{package}'))"]).strip()


def compiler_version(command):
    return f"{command.split('-')[0]} {run([command, '-dumpfullversion', '-dumpversion']).strip()}"


def compiled(folder, name, command, sources, timeout=None):
    """The shared object folder/NAME-HASH.so of these sources; compiled where it is missing or a source or the command has changed. Sources
    include headers: what is not a header is compiled. None where it took longer than the timeout, in seconds."""
    key = hashlib.sha256(" ".join(map(str, command)).encode())
    for source in [*sources, BENCH / "contender.h"]:
        key.update(pathlib.Path(source).read_bytes())
    target = folder / f"{name}-{key.hexdigest()[:16]}.so"
    partial = target.with_suffix(f".{os.getpid()}")
    if not target.exists():
        units = [source for source in sources if pathlib.Path(source).suffix != ".h"]
        try:
            run([*command, "-shared", "-fPIC", f"-I{BENCH}", *units, "-o", partial, "-lm"], timeout=timeout)
        except subprocess.TimeoutExpired:
            return None
        partial.rename(target)
    return target
