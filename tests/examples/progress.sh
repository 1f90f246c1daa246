#!/usr/bin/env bash
# progress.sh PROGRAM OPTION..: progress with the time left on a terminal, none without one.
. "$(dirname "$0")/expect.sh"
command -v script >/dev/null || { echo "no script(1) to make a terminal: skipped"; exit 77; }
timeout -s INT 5 script -qec "timeout -s INT 3 $*" scratch/terminal.txt >/dev/null 2>&1 </dev/null
says scratch/terminal.txt '[0-9.]+ %, [0-9]+ s left'
timeout -s INT 1.5 "$@" >scratch/out.txt 2>scratch/err.txt </dev/null
grep -q left scratch/err.txt && fail "progress without a terminal"
exit 0
