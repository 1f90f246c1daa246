"""What the rivals' timers share: scenes from standard input, repeats on the CPU's clock, and rows of results on standard output."""
import json
import statistics
import sys
import time

MOST_SECONDS = {False: 0.6, True: 0.05}  # of one run: a finer one would take too long; quick: True
SECONDS, REPEATS = 0.2, 15               # of all repeats of one setting


def scenes(known):
    """Those on standard input that are known here: dictionaries with scene, t_end, q and qd."""
    return [scene for scene in map(json.loads, sys.stdin) if scene["scene"] in known]


def note(text):
    print(f"# {text}", flush=True)


def repeat(run, quick):
    """(least, median) CPU seconds of run(), and what the last one returned."""
    taken = []
    while not taken or (not quick and len(taken) < REPEATS and sum(taken) < SECONDS):
        start = time.process_time()
        result = run()
        taken.append(time.process_time() - start)
    return min(taken), statistics.median(taken), result


def row(scene, contender, method, setting, cpu, median, steps, evaluations, state):
    """One line for `precision judge`; steps and evaluations are 0 where they are not known."""
    numbers = ",".join(f"{x:.17g}" for x in state)
    print(f"{scene['scene']},{contender},{method},{setting},{cpu:.6g},{median:.6g},{steps},{evaluations},{numbers}", flush=True)


def tolerances(quick, step=1, tightest=16):
    return [10.0 ** -k for k in range(4 if step == 3 else 3, tightest + 1, 6 if quick else step)]
