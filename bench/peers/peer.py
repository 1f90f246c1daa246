"""What the build scripts of the rivals share beyond building.py: virtual environments from PyPI, made once for all cases."""
import contextlib
import fcntl
import subprocess
import sys
import sysconfig
from pathlib import Path

PEERS = Path(__file__).resolve().parent
sys.path.insert(0, str(PEERS.parent))
import building  # noqa: E402


@contextlib.contextmanager
def alone(folder, name):
    """Only one build script at a time gets into this block."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / f"{name}.lock", "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def environment(args, name, packages):
    """The Python of a virtual environment with these packages; made where it is missing or holds others."""
    venv = args.env.resolve() / f"{name}-venv"
    stamp, wanted = venv / "packages", " ".join(packages)
    with alone(args.env, f"{name}-venv"):
        if not (stamp.exists() and stamp.read_text(encoding="utf-8") == wanted):
            for command in ([sys.executable, "-m", "venv", "--clear", venv],
                            [venv / "bin/pip", "install", "--quiet", "--disable-pip-version-check", *packages]):
                done = subprocess.run(command, text=True, stdout=sys.stderr, check=False)
                if done.returncode:
                    building.absent(f"'{' '.join(map(str, command))}' failed")
            stamp.write_text(wanted, encoding="utf-8")
    return venv / "bin/python"


def site_packages(python):
    """Where the packages of an environment are."""
    venv = str(python.parent.parent)
    return Path(sysconfig.get_path("purelib", vars={"base": venv, "platbase": venv}))
