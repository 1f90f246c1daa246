"""A page of documentation: its files are written, its commands run against the installed package, and their output compared with the
page's.

    guide.py PAGE FOLDER PREFIX
"""
import os
import re
import shutil
import subprocess
import sys

guide, folder, prefix = sys.argv[1], sys.argv[2], os.path.abspath(sys.argv[3])
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
page = open(guide, encoding="utf-8").read()
blocks = re.findall(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", page, re.M | re.S)
pkgconfig = [root for root, _, files in os.walk(prefix) if "libtaylor.pc" in files]
path = os.pathsep.join([os.path.join(prefix, "bin"), os.environ["PATH"]])
environment = dict(os.environ, PATH=path, PKG_CONFIG_PATH=pkgconfig[0])
failed = 0


def run(command):
    """What a command prints; a failure is told and counted."""
    global failed
    done = subprocess.run(["bash", "-ec", command], cwd=folder, env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        failed += 1
        print(f"$ {command}\nexit status {done.returncode}\n{done.stderr}")
    return done.stdout


def same(printed, expected):
    global failed
    if printed != expected:
        failed += 1
        print(f"printed:\n{printed}the page says:\n{expected}")


for _, name, text in blocks:
    if name:
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)

printed, compared = "", 0
for kind, name, text in blocks:
    if kind == "sh":
        printed = run(text.replace("PREFIX", prefix))
    elif kind == "text":
        same(printed, text)
        compared += 1

# A page's CMakeLists.txt, whose models use the folders it names, makes the program of its first output.
if any(name == "CMakeLists.txt" for _, name, _ in blocks):
    os.makedirs(os.path.join(folder, "include"), exist_ok=True)
    first = next(text for kind, _, text in blocks if kind == "text")
    same(run(f"cmake -S . -B build -DCMAKE_PREFIX_PATH={prefix} >/dev/null && cmake --build build >log && build/rod_main"), first)
if compared < 2:
    sys.exit(f"only {compared} outputs on the page")
sys.exit(1 if failed else 0)
