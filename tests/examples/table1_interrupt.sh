#!/usr/bin/env bash
# table1_interrupt.sh PROGRAM: Ctrl-C during Table 1 marks every run that did not reach its end with the time that it reached, draws no
# conclusion, and leaves the figures out that would have nothing to show.
. "$(dirname "$0")/expect.sh"
set -m # or the shell starts background programs with Ctrl-C ignored
timeout -s KILL 100 "$1" --table1 --links 3 --t-end 1e5 --every 0.5 --figures out --csv table.csv >scratch/out.txt 2>scratch/err.txt </dev/null &
id=$!
sleep 2
kill -INT $id
wait $id
status=$?
[ $status -eq 130 ] || fail "exit status $status, not 130"
says scratch/out.txt '; stopped on the way to t = 100000 s$'
grep -Eq '; t = 100000 s$|, t = 50000 s$' scratch/out.txt && fail "the time that was asked for stands as if it had been reached"
grep -Eq ' never  |inside|outside|overflows at the|falls with|So the values' scratch/out.txt && fail "a stopped table concludes"
says scratch/out.txt 'no conclusions are drawn'
awk '/^ [1-3] / { rows++; if (/ (stopped|overflows|overflowed) (at|after) [0-9.e+]+ s| in [0-9.e+]+ s \(stopped\)/) next; print; bad = 1 } END { exit bad || rows != 9 }' \
  <(sed '/no conclusions/,$d' scratch/out.txt) || fail "a row of a stopped run that does not say so"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next } { t = $column["t"]; if (!(t > 0 && t < 1e5)) exit 1 }' table.csv ||
  fail "table.csv does not say the time that was reached"
grep -Ei 'empty|warning' scratch/err.txt && fail "gnuplot's warnings reach the user"
exit 0
