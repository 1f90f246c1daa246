#!/usr/bin/env bash
# interrupt.sh PROGRAM OPTION..: Ctrl-C, or the end of its terminal, during a long run keeps the whole rows there are, says so and exits with status 130.
. "$(dirname "$0")/../examples/expect.sh"
set -m # or the shell starts background programs with Ctrl-C ignored
for signal in INT HUP; do # env: where the tests themselves run under nohup
  rm -f run.csv run.npz
  env --default-signal=HUP timeout -s KILL 100 "$@" --csv run.csv --npz run.npz >scratch/out.txt 2>scratch/err.txt </dev/null &
  id=$!
  sleep 1
  [ -e run.csv ] && fail "the file is there before the run has ended"
  kill -$signal $id
  wait $id
  status=$?
  [ $status -eq 130 ] || fail "exit status $status after SIG$signal, not 130"
  says scratch/err.txt 'stopped by the user at t = '
  awk -F, 'NR == 1 { n = NF } NF != n || $NF == "" { exit 1 } END { exit NR < 3 }' run.csv || fail "no rows, or a row that is not whole"
  leaves run.csv run.npz
done

# With nohup the end of the terminal is none of the run's business.
nohup "$@" --csv run.csv >scratch/out.txt 2>scratch/err.txt </dev/null &
id=$!
sleep 1
kill -HUP $id
sleep 0.2
kill -INT $id || fail "a run under nohup has ended with the terminal"
wait $id
status=$?
[ $status -eq 130 ] || fail "exit status $status under nohup, not 130"
