"""From programs to numbers: tlgen, compilers, and one executable per batch."""
import os
import re
import signal
import subprocess

# How the generated code is compiled; a batch takes one of them. What DESIGN warns of, vectorised straight-line code, is switched off.
OPTIMISED = ["-O3", "-march=native", "-ffp-contract=fast", "-fno-math-errno"]
CONFIGURATIONS = {
    "gcc-O0": ["gcc", "-O0"],
    "clang-O3": ["clang-19", *OPTIMISED, "-fno-slp-vectorize"],
    "gcc-O3": ["gcc", *OPTIMISED, "-fno-tree-slp-vectorize"],
    "clang-O0": ["clang-19", "-O0"],
    "gcc-sanitize": ["gcc", "-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"],
}
# What motion functions are printed with: by turns.
VARIANTS = ["", "--form registers --lanes", "--form rows"]
# The programs compute things that nobody uses, and compare numbers with themselves: so does what is made of them.
SENSELESS = ["unused-but-set-variable", "self-assign", "tautological-compare", "array-bounds"]
WARNINGS = ["-std=c11", "-Wall", "-Wextra", "-Wconversion", "-Werror", *(f"-Wno-{name}" for name in SENSELESS)]
# How the plain C in quad precision is compiled: a call in each basic block.
FOLLOWED = ["gcc", "-w", "-O0", "-fsanitize-coverage=trace-pc"]
# The same in double.
ROUNDED = ["-D__float128=double", "-DTLGEN_QUAD_H", "-Dtlgen_selftest_main=fuzz_keep_rounded"]
# Functions of a model, at most.
FUNCTIONS = 6
# Of the processor's time, for one program: what takes longer has gone astray.
SECONDS_TO_GENERATE = 10
SECONDS_TO_COMPILE = 60
# Bytes of generated code beyond which it is compiled without optimisation, whose time grows faster than the code; and beyond which motion
# functions are left out.
LARGE, TOO_LARGE = 60000, 200000


class Result:
    """What is known of one program: faults as texts, the largest error of each (way, group), counts of points."""

    def __init__(self):
        self.faults, self.errors, self.points = [], {}, {}
        self.unsuitable = ""  # why there are no motion functions

    def fault(self, way, text):
        self.faults.append((way, text))

    @property
    def kinds(self):
        """The ways that failed, without numbers: what a reduced program must fail in too."""
        return {(way, re.sub(r"[\[:(].*|[0-9]+", "", text).strip()) for way, text in self.faults}


def run(command, folder, seconds=600, **more):
    """Runs a command with a limit of processor time, in a session of its own: who stops the run at the terminal does not stop what is half
    done."""
    limited = ["bash", "-c", f'ulimit -t {seconds}; exec "$@"', "bash", *command]
    return subprocess.run(limited, cwd=folder, capture_output=True, text=True, check=False, start_new_session=True, **more)


def too_long(done):
    return -done.returncode in (signal.SIGXCPU, signal.SIGKILL)


def first_error(done):
    """The first line that says what went wrong."""
    if done.returncode < 0:
        return "takes too long" if too_long(done) else f"crashes with signal {-done.returncode}"
    errors = [line for line in done.stderr.splitlines() if "error" in line] or done.stderr.splitlines() or [f"exit status {done.returncode}"]
    return errors[0].split("error: ")[-1]


class Builder:
    """Checks batches of programs in a folder of their own."""

    def __init__(self, build, stop, spoiled=False):
        self.stop = stop  # an event: what is not begun is left
        self.spoiled = spoiled
        with open(os.path.join(build, "tests", "fuzz", "paths.txt"), encoding="utf-8") as file:
            paths = dict(line.rstrip("\n").split(" ", 1) if " " in line else (line.strip(), "") for line in file)
        self.tlgen = paths["tlgen"]
        self.includes = [f"-I{path}" for path in paths["includes"].split(";")]
        self.libraries = paths["libraries"].split(";")
        self.motions = "--need" in run([self.tlgen, "--help"], ".").stdout
        self.sanitizers = [flag for flag in paths["sanitizers"].split(";") if flag]

    def model_line(self, program, variant):
        motion = f"{'' if '--need' in variant else '--need all'} {program.motion} {variant}" if self.motions else ""
        return f"{program.name}.c {program.options} {motion} --model {program.name} --selftest -o {program.name}_tl.c"

    @staticmethod
    def read_notes(text, results):
        """Why some have no motion functions."""
        for name, why in re.findall(r"^(\w+)\.c:\d+:\d+: note: (.*): No motion functions", text, re.M):
            results[name].unsuitable = why

    def generate(self, programs, folder, variant, results):
        """Runs tlgen on all; where it refuses some, or takes too long, on each. Returns those that it accepts."""
        with open(os.path.join(folder, "models"), "w", encoding="utf-8") as file:
            file.write("\n".join(self.model_line(p, variant) for p in programs) + "\n")
        done = run([self.tlgen, "--models", "models"], folder, SECONDS_TO_GENERATE)
        if done.returncode == 0:
            self.read_notes(done.stderr, results)
            accepted = programs
        else:
            accepted = [p for p in programs if not self.stop.is_set() and self.generate_one(p, folder, variant, results)]
        for program in accepted:
            if self.size(program, folder) > TOO_LARGE:
                self.leave_motion_out(program, folder, results, f"more than {TOO_LARGE} bytes of code")
        return accepted

    def generate_one(self, program, folder, variant, results):
        done = run([self.tlgen, *self.model_line(program, variant).split()], folder, SECONDS_TO_GENERATE)
        if too_long(done) and self.motions:
            done = self.leave_motion_out(program, folder, results, f"tlgen takes longer than {SECONDS_TO_GENERATE} s")
        self.read_notes(done.stderr, results)
        if done.returncode != 0:
            results[program.name].fault("tlgen", first_error(done))
        return done.returncode == 0

    def leave_motion_out(self, program, folder, results, why):
        results[program.name].unsuitable = why
        return run([self.tlgen, *self.model_line(program, "--need none").split()], folder, SECONDS_TO_GENERATE)

    @staticmethod
    def size(program, folder):
        return os.path.getsize(os.path.join(folder, f"{program.name}_tl.c"))

    @staticmethod
    def spoil(program, folder):
        """Puts a wrong function into the generated code, which the check must notice."""
        path = os.path.join(folder, f"{program.name}_tl.c")
        with open(path, encoding="utf-8") as file:
            text = file.read()
        with open(path, "w", encoding="utf-8") as file:
            file.write(re.sub(r"\b((?:tl_)?)sin\(", r"\1cos(", text))

    def compiler(self, program, folder, configuration):
        large = self.size(program, folder) > LARGE
        return [flag if not (large and re.fullmatch("-O[123]", flag)) else "-O0" for flag in CONFIGURATIONS[configuration]]

    @staticmethod
    def rounded(name):
        """How the printed test is compiled in double, with other names for what it has in common with the one in quad precision."""
        names = [f"-D{name}_quad_{k}={name}_rounded_{k}" for k in range(1, FUNCTIONS + 1)]
        return [*ROUNDED, *names, f"-D{name}_params={name}_rounded_params", f"-Dmain={name}_rounded"]

    def compile(self, programs, folder, configuration, results):
        """Objects of those that compile: generated code, and the plain C in quad precision and in double with its path followed."""
        compiled, objects = [], []
        for p in programs:
            if self.spoiled:
                self.spoil(p, folder)
            if self.stop.is_set():
                break
            compiler = [*self.compiler(p, folder, configuration), *WARNINGS, *self.includes]
            generated = run([*compiler, "-c", f"{p.name}_tl.c"], folder, SECONDS_TO_COMPILE)
            plain = run([*FOLLOWED, f"-Dmain={p.name}_test", *self.includes, "-c", f"{p.name}_selftest.c"], folder)
            rounded = run([*FOLLOWED, *self.rounded(p.name), *self.includes, "-c", f"{p.name}_selftest.c", "-o", f"{p.name}_rounded.o"], folder)
            for done in (generated, plain, rounded):
                if done.returncode != 0:
                    results[p.name].fault("compiler", first_error(done))
                    break
            else:
                compiled.append(p)
                objects += [f"{p.name}_tl.o", f"{p.name}_selftest.o", f"{p.name}_rounded.o"]
        return compiled, objects

    def batch_source(self, programs):
        """The C file that lists the programs."""
        out = ["/* A batch of random programs. */", '#include "batch.h"', ""]
        out += [f"int {p.name}_test(int, char **), {p.name}_rounded(int, char **);" for p in programs]
        rows = [f'    {{{p.name}_test, {p.name}_rounded, "{p.name}", "{p.params}"}},' for p in programs]
        return "\n".join(out + ["", "int main(void) {", "  static const fuzz_program programs[] = {", *rows, "  };",
                                f"  return fuzz_batch(programs, {len(programs)});", "}", ""])

    def check(self, programs, folder, configuration, variant):
        """A Result by name for each program."""
        results = {p.name: Result() for p in programs}
        for p in programs:
            with open(os.path.join(folder, f"{p.name}.c"), "w", encoding="utf-8") as file:
                file.write(p.text)
        programs, objects = self.compile(self.generate(programs, folder, variant, results), folder, configuration, results)
        if not programs:
            return results
        with open(os.path.join(folder, "batch.c"), "w", encoding="utf-8") as file:
            file.write(self.batch_source(programs))
        flags = self.sanitizers or [flag for flag in CONFIGURATIONS[configuration] if flag.startswith("-fsanitize")]
        linked = run(["gcc", *flags, *self.includes, "batch.c", *objects, *self.libraries, "-o", "batch"], folder)
        if linked.returncode != 0:
            raise RuntimeError("the batch does not link:\n" + linked.stderr)
        environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", ASAN_OPTIONS="detect_leaks=0")
        done = run(["./batch"], folder, env=environment)
        self.read(done.stdout, results)
        for p in programs:
            if not results[p.name].points and not results[p.name].faults:
                results[p.name].fault("run", "no result: " + (done.stderr.splitlines() or ["?"])[0])
        return results

    @staticmethod
    def read(text, results):
        for line in text.splitlines():
            name, what, *rest = line.split(" ", 2)
            if name not in results or not rest:
                continue
            if what == "FAULT":
                way, _, message = rest[0].partition(": ")
                results[name].fault(way if message else "run", message or way)
            elif what == "done":
                words = rest[0].split()
                results[name].points = {word: int(number) for number, word in zip(words[::2], words[1::2])}
            else:
                group, number = rest[0].split()
                results[name].errors[what, group] = float(number)
