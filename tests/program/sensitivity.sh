#!/usr/bin/env bash
# sensitivity.sh PROGRAM MODELS ROD: derivatives beside a motion, against what they must satisfy and against differences of motions.
. "$(dirname "$0")/../examples/expect.sh"
program=$1 models=$2 rod=$3

# A state moved along the motion stays on it: the derivatives in that direction, f(y0) = (0, 1, -1, 0), are f at every time.
for method in dop853 cvode_bdf; do
  "$program" run --help | grep -q "^  $method " || continue # without SUNDIALS
  run 0 "$program" run "$models/kepler.so" --q 1,0 --qd 0,1 --t-end 3 --rtol 1e-11 --atol 1e-11 --method $method \
    --sensitivity 'qd[0],q[1]' --csv run.csv
  awk -F, 'NR == 1 { exit !($8 == "d q[0]/d qd[0]" && $9 == "d q[0]/d q[1]") }' run.csv || fail "other columns: $(head -1 run.csv)"
  awk -F, 'NR > 1 { r = -0.5 * log($2 * $2 + $3 * $3); c = exp(3 * r); f[0] = $4; f[1] = $5; f[2] = -$2 * c; f[3] = -$3 * c
      for (i = 0; i < 4; i++) { d = $(9 + 2 * i) - $(8 + 2 * i) - f[i]; if (d < 0) d = -d; if (d > worst) worst = d } }
    END { print "largest difference", worst; exit !(NR == 1002 && worst < 1e-6 && worst > 0) }' run.csv || fail "not the derivatives by $method"
done

# By a parameter, on a constraint: differences of two motions.
state() { # state GRAVITY: q[0] at the end
  run 0 "$program" run "$rod" --set mass=1 --set length=1 --set gravity="$1" --q 1,0 --t-end 1 --rtol 1e-12 --atol 1e-12 --csv run.csv
  tail -1 run.csv | cut -d, -f2
}
up=$(state 9.8101) down=$(state 9.8099)
run 0 "$program" run "$rod" --set mass=1 --set length=1 --set gravity=9.81 --q 1,0 --t-end 1 --rtol 1e-12 --atol 1e-12 \
  --sensitivity gravity --npz run.npz
says scratch/out.txt '^  by +gravity$'
awk -v up="$up" -v down="$down" '$1 == "q[0]" && NF == 2 { d = $2 - (up - down) / 0.0002; found = d * d < 1e-14 } END { exit !found }' \
  scratch/out.txt || fail "not ($up - $down) / 0.0002: $(cat scratch/out.txt)"
