#!/usr/bin/env bash
# sensitivity.sh PROGRAM MODELS ROD: derivatives beside a motion, against what they must satisfy and against differences of motions.
. "$(dirname "$0")/../examples/expect.sh"
program=$1 models=$2 rod=$3
help=$("$program" run --help)

# A state moved along the motion stays on it: the derivatives in that direction, f(y0) = (0, 1, -1, 0), are f at every time.
for method in dop853 cvode_bdf; do
  grep -q "^  $method " <<<"$help" || continue # without SUNDIALS
  run 0 "$program" run "$models/kepler.so" --q 1,0 --qd 0,1 --t-end 3 --rtol 1e-11 --atol 1e-11 --method $method \
    --sensitivity 'qd[0],q[1]' --csv run.csv
  awk -F, 'NR == 1 { exit !($8 == "d q[0]/d qd[0]" && $9 == "d q[0]/d q[1]") }' run.csv || fail "other columns: $(head -1 run.csv)"
  awk -F, 'NR > 1 { r = -0.5 * log($2 * $2 + $3 * $3); c = exp(3 * r); f[0] = $4; f[1] = $5; f[2] = -$2 * c; f[3] = -$3 * c
      for (i = 0; i < 4; i++) { d = $(9 + 2 * i) - $(8 + 2 * i) - f[i]; if (d < 0) d = -d; if (d > worst) worst = d } }
    END { print "largest difference", worst; exit !(NR == 1002 && worst < 1e-6 && worst > 0) }' run.csv || fail "not the derivatives by $method"
done

# By a parameter, on a constraint: differences of two motions, from a start that satisfies the constraint and from ones that are brought
# onto it, so that where they begin depends on the parameter.
state() { # state PARAMETER VALUE OPTION..: q[0] at the end
  run 0 "$program" run "$rod" --set mass=1 --set length=1 --set gravity=9.81 --set "$1=$2" --t-end 1 --rtol 1e-12 --atol 1e-12 --csv run.csv "${@:3}"
  tail -1 run.csv | cut -d, -f2
}
differentiated() { # differentiated PARAMETER UP DOWN OPTION..
  local up down
  up=$(state "$1" "$2" "${@:4}") down=$(state "$1" "$3" "${@:4}")
  run 0 "$program" run "$rod" --set mass=1 --set length=1 --set gravity=9.81 --t-end 1 --rtol 1e-12 --atol 1e-12 --sensitivity "$1" --npz run.npz "${@:4}"
  says scratch/out.txt "^  by +$1\$"
  awk -v up="$up" -v down="$down" -v high="$2" -v low="$3" \
    '$1 == "q[0]" && NF == 2 { d = $2 - (up - down) / (high - low); found = d * d < 1e-14 } END { exit !found }' scratch/out.txt ||
    fail "d q[0]/d $1 is not ($up - $down) / ($2 - $3): $(cat scratch/out.txt)"
}
differentiated gravity 9.8101 9.8099 --q 1,0
differentiated length 1.0001 0.9999 --q 1,0
differentiated length 1.0001 0.9999 --q 1.2,-0.3 --qd 0.5,0.7
differentiated length 1.0001 0.9999 --q 0.8,0.5 --qd 0,1 --keep 'q[1],qd[1]'
differentiated mass 1.0001 0.9999 --q 1.2,-0.3
