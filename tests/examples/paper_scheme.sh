#!/usr/bin/env bash
# paper_scheme.sh PROGRAM: the scheme as printed, at the step that the paper states, loses Q and overflows; the program says when, keeps
# the rows until then and exits with status 1.
. "$(dirname "$0")/expect.sh"
run 1 "$1" --scheme paper --t-end 10 --every 0.1 --csv p.csv
says scratch/err.txt "N = 2: a number overflowed after t = 0\.[0-9]+ s of 10 s"
rows=$(($(wc -l <p.csv) - 1))
[ $rows -ge 2 ] && [ $rows -le 10 ] || fail "$rows rows, wanted a few until the overflow"
# Half-widths, columns 10 to 13, are infinite where there are too few blocks of time.
grep -qi nan p.csv || cut -d, -f1-9,14- p.csv | grep -qi inf && fail "a number that is not finite in the rows"
awk -F, 'END { exit !($NF > 1) }' p.csv || fail "the last row shows no loss of orthogonality"
leaves p.csv
# The same scheme, re-orthonormalised, lives at that step.
run 0 "$1" --scheme continuous --step 0.05 --t-end 10 --csv c.csv
awk -F, 'NR > 1 && $NF > 1e-12 { exit 1 }' c.csv || fail "--scheme continuous does not keep Q orthogonal"
