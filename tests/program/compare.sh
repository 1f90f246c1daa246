#!/usr/bin/env bash
# compare.sh PROGRAM MODELS PYTHON: eom compare on a planet whose motion is known: the errors that it prints are the true ones.
. "$(dirname "$0")/../examples/expect.sh"
program=$1 models=$2 python=$3
circle="$models/kepler.so --q 1,0 --qd 0,1 --t-end 3"
run 0 "$program" compare $circle --methods dop853,dp5,rk4 --tolerances 1e-5,1e-7,1e-9 --repeats 1 --csv c.csv --page c.html
says scratch/out.txt '^Reference: dop853; it agrees with dp5 to [0-9.e-]+: '
[ "$(grep -c '^dop853 \|^dp5 \|^rk4 ' scratch/out.txt)" -eq 9 ] || fail "not nine runs"
says c.html '^<!doctype html>|^<!DOCTYPE html>'
[ "$(grep -c '<svg' c.html)" -ge 3 ] || fail "not three plots on the page"
grep -Eq '(src|href)="?http' c.html && fail "the page needs the network"

# The same runs once more, as rows with their true errors by the closed form.
while IFS=, read -r method tolerance _ _ error _ steps _; do
  [ "$method" = method ] && continue
  run 0 "$program" run $circle --method "$method" --rtol "$tolerance" --atol "$tolerance" --csv r.csv
  says scratch/out.txt " by $method: $steps steps,"
  "$python" - "$error" <<'EOF' || fail "$method at $tolerance: the error is not $error"
import csv, math, sys
last = [float(x) for x in list(csv.reader(open("r.csv")))[-1]]
truth = [math.cos(3), math.sin(3), -math.sin(3), math.cos(3)]
error = max(abs(x - y) for x, y in zip(last[1:5], truth)) # the largest coordinate and velocity are 1 at the start
sys.exit(not abs(error - float(sys.argv[1])) < 1e-12 + 0.02 * error)
EOF
done <c.csv
run 0 "$program" compare $circle --methods rk4 --tolerances 1e-6 --repeats 1

# A planet that falls into the sun has no end to compare; nor has chaos, where two references part.
run 1 timeout -s KILL 60 "$program" compare "$models/kepler.so" --q 1,0 --t-end 3 --methods dop853
says scratch/err.txt '^eom: no reference: no method reaches the end at its tolerance; dop853 fails at t = 1\.1107[0-9]* s: ' # pi / 2^(3/2)
run 1 timeout -s KILL 100 "$program" compare "$models/pendulum.so" --set n=2 --set g=9.81 --set mass=1 --set length=1 --q 3,3 --t-end 60 --methods dp5
says scratch/err.txt '^eom: no reference: dop853 and dp5 differ by'
