#!/usr/bin/env bash
# figure_rows.sh PROGRAM: a curve needs two rows. Fewer are refused where that is known before the run, and left out with a word where a
# run ends early; gnuplot's warnings do not reach the user.
. "$(dirname "$0")/expect.sh"
for figure in "--plot a.svg" "--figures out"; do
  run 2 "$1" --t-end 0.3 $figure
  says scratch/err.txt '--every 0\.5 .*one row.*two'
done
leaves
run 1 "$1" --scheme paper --t-end 10 --plot a.svg # overflows in the first second
says scratch/err.txt "'a\.svg' is left out: .* two rows"
grep -Eqi 'warning' scratch/err.txt && fail "a warning of gnuplot"
leaves
# Nothing moves: every energy error is zero.
run 0 "$1" --links 1 --theta0 0 --t-end 2 --step 0.01 --figures out
[ -s scratch/err.txt ] && fail "messages beside the figures"
leaves out
