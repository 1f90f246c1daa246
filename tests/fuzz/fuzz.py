"""Random C programs through tlgen: what the generated code computes beside differences of the same C in quad precision.

Each program is a Lagrangian, often with forces and constraints, in the C that tlgen accepts, made from a seed. A program that fails is
reduced while it still fails in the same way, and kept as a test.
"""
import argparse
import collections
import concurrent.futures
import os
import re
import shutil
import signal
import sys
import tempfile
import threading

import generate
import reduce
from build import CONFIGURATIONS, VARIANTS, Builder

HERE = os.path.dirname(os.path.abspath(__file__))
KEPT = os.path.join(HERE, "kept")
BATCH = 20


class Source:
    """A program as the batches take it; the options and parameters stand in its first comments."""

    def __init__(self, name, text):
        self.name, self.text = name, text
        self.options = self.comment("tlgen")
        self.motion = self.comment("motion")
        self.params = self.comment("params")

    def comment(self, word):
        found = re.search(rf"/\* {word}: (.*?) *\*/", self.text)
        return found.group(1) if found else ""


class Tally:
    """Everything found so far."""

    def __init__(self):
        self.programs = collections.Counter()
        self.points = collections.Counter()
        self.errors = collections.defaultdict(list)
        self.unsuitable = collections.Counter()
        self.failed = {}

    def add(self, name, how, result):
        self.programs[how[0]] += 1
        self.points.update(result.points)
        self.unsuitable.update([result.unsuitable] if result.unsuitable else [])
        for key, error in result.errors.items():
            self.errors[key].append(error)
        if result.faults:
            self.failed[name] = (how, result)

    def print(self):
        total = sum(self.programs.values())
        print(f"{total} programs ({', '.join(f'{count} {name}' for name, count in sorted(self.programs.items()))}), "
              f"{self.points['points']} points, {self.points['solved']} of them with accelerations; "
              f"left out {self.points['rough']} near a kink, {self.points['large']} with numbers too large, "
              f"{self.points['rounded']} where rounding in double takes the source itself elsewhere")
        print(f"{self.points['motions']} programs have motion functions")
        for why, count in self.unsuitable.most_common():
            print(f"  {count} have none: {why}")
        if self.errors:
            print("\nerrors relative to the group's scale, the larger of each program's points\n"
                  f"{'way':12} {'numbers':10} {'programs':>8} {'median':>9} {'99 %':>9} {'largest':>9}")
        for (way, group), errors in sorted(self.errors.items()):
            errors.sort()
            at = [errors[int(part * (len(errors) - 1))] for part in (0.5, 0.99, 1.0)]
            print(f"{way:12} {group:10} {len(errors):8} " + " ".join(f"{e:9.2g}" for e in at))
        print(f"\n{len(self.failed)} programs failed", flush=True)


class Fuzz:
    """A run: its batches, its tally, its folder."""

    def __init__(self, arguments):
        self.arguments = arguments
        self.stop = threading.Event()
        self.builder = Builder(arguments.build, self.stop, arguments.spoil)
        self.tally = Tally()
        self.folder = tempfile.mkdtemp(prefix="fuzz-", dir=os.path.join(arguments.build, "tests", "fuzz"))
        self.lock = threading.Lock()
        self.trees = {}
        self.done = 0

    def batches(self):
        """Lists of sources, each with the configuration that compiles it and the variant of tlgen's options."""
        names = list(CONFIGURATIONS)
        if self.arguments.kept:
            sources = []
            for file in sorted(os.listdir(KEPT) if os.path.isdir(KEPT) else []):
                with open(os.path.join(KEPT, file), encoding="utf-8") as text:
                    sources.append(Source(os.path.splitext(file)[0], text.read()))
            return [(sources, configuration, variant) for configuration in names for variant in VARIANTS if sources]
        count = self.arguments.count
        size = min(BATCH, max(1, -(-count // len(names))))
        starts = enumerate(range(0, count, size))
        return [(range(start, min(start + size, count)), names[k % len(names)], VARIANTS[k % len(VARIANTS)]) for k, start in starts]

    def sources(self, batch):
        if not isinstance(batch, range):
            return batch
        sources = []
        for k in batch:
            name = f"p{self.arguments.seed}_{k}"
            tree = generate.generate(name, f"{self.arguments.seed}-{k}")
            self.trees[name] = tree
            sources.append(Source(name, str(tree)))
        return sources

    def work(self, number, batch, configuration, variant):
        """Checks one batch in a folder that is removed afterwards."""
        if self.stop.is_set():
            return
        folder = os.path.join(self.folder, str(number))
        os.mkdir(folder)
        sources = self.sources(batch)
        results = self.builder.check(sources, folder, configuration, variant)
        shutil.rmtree(folder)
        if self.stop.is_set():
            return
        with self.lock:
            for source in sources:
                self.tally.add(source.name, (configuration, variant), results[source.name])
                if not results[source.name].faults:
                    self.trees.pop(source.name, None)
            self.done += len(sources)
            if sys.stderr.isatty():
                print(f"\r{self.done} programs, {len(self.tally.failed)} failed ", end="", file=sys.stderr, flush=True)

    def check(self):
        """Checks all batches, or those that are done when the user stops it."""
        pool = concurrent.futures.ThreadPoolExecutor(self.arguments.jobs)
        try:
            for done in [pool.submit(self.work, k, *batch) for k, batch in enumerate(self.batches())]:
                done.result()
        except KeyboardInterrupt:
            self.stop.set()
            print("\nstopped; until then:", file=sys.stderr)
        pool.shutdown(wait=True, cancel_futures=True)
        if sys.stderr.isatty():
            print(file=sys.stderr)

    def run(self):
        """Checks, prints, reduces. Returns the exit status."""
        try:
            self.check()
            self.tally.print()
            for name, (how, result) in sorted(self.tally.failed.items()):
                self.tell(name, how, result)
        except KeyboardInterrupt:
            self.stop.set()
        finally:
            shutil.rmtree(self.folder, ignore_errors=True)
        return 130 if self.stop.is_set() else 1 if self.tally.failed else 0

    def tell(self, name, how, result):
        print(f"\n{name} with {' '.join(how)}")
        for way, text in result.faults[:5]:
            print(f"  {way}: {text}", flush=True)
        if name in self.trees and not self.arguments.no_reduce and not self.stop.is_set():
            self.keep(name, how, result)

    def keep(self, name, how, result):
        """Reduces a failing program and writes it among the kept ones."""
        folder = os.path.join(self.folder, name)
        os.mkdir(folder)
        wanted = result.kinds

        def fails(tree):
            again = self.builder.check([Source(name, str(tree))], folder, *how)[name]
            return bool(wanted & again.kinds)

        tree = reduce.reduce(self.trees[name], fails)
        way, text = result.faults[0]
        tree.purpose = f"Failed in {way}: {text.split(' is ')[0].split(';')[0]}.".replace("*/", "")
        os.makedirs(KEPT, exist_ok=True)
        path = os.path.join(KEPT, f"{name}.c")
        with open(path, "w", encoding="utf-8") as file:
            file.write(str(tree))
        print(f"  kept, reduced, as {os.path.relpath(path)}")


def parse():
    parser = argparse.ArgumentParser(prog="scripts/fuzz", description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("build", help="the folder where the project and its tests were built")
    parser.add_argument("--count", type=int, default=2000, help="number of programs (default 2000)")
    parser.add_argument("--seed", default="1", help="the same seed makes the same programs (default 1)")
    parser.add_argument("--jobs", type=int, default=2, help="batches at a time (default 2)")
    parser.add_argument("--kept", action="store_true", help="check the programs of tests/fuzz/kept instead of new ones")
    parser.add_argument("--no-reduce", action="store_true", help="do not reduce and keep what fails")
    parser.add_argument("--spoil", action="store_true", help="put errors into the generated code: a test of this program, which must fail")
    return parser.parse_args()


def interrupt(*_):
    raise KeyboardInterrupt


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, interrupt)
    sys.exit(Fuzz(parse()).run())
