#!/usr/bin/env bash
# interrupt.sh PROGRAM OPTION..: Ctrl-C during a long run keeps the whole rows there are, says so and exits with status 130.
. "$(dirname "$0")/../examples/expect.sh"
set -m # or the shell starts background programs with Ctrl-C ignored
timeout -s KILL 100 "$@" --csv run.csv --npz run.npz >scratch/out.txt 2>scratch/err.txt </dev/null &
id=$!
sleep 1
[ -e run.csv ] && fail "the file is there before the run has ended"
kill -INT $id
wait $id
status=$?
[ $status -eq 130 ] || fail "exit status $status, not 130"
says scratch/err.txt 'stopped by the user at t = '
awk -F, 'NR == 1 { n = NF } NF != n || $NF == "" { exit 1 } END { exit NR < 3 }' run.csv || fail "no rows, or a row that is not whole"
leaves run.csv run.npz
