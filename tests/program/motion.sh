#!/usr/bin/env bash
# motion.sh PROGRAM MODELS PYTHON: eom run against closed forms, its files against each other, and the same bytes in every run.
. "$(dirname "$0")/../examples/expect.sh"
here=$(cd "$(dirname "$0")" && pwd) program=$1 models=$2 python=$3
help=$("$program" run --help)

# A planet on a circle: q = (cos t, sin t). Every method, to an error that its tolerance or step explains.
circle="$models/kepler.so --q 1,0 --qd 0,1 --t-end 6 --every 0.06 --column dx=q[0]-cos(t) --column dy=q[1]-sin(t)"
within() { # within TOLERANCE: the columns dx and dy of run.csv are below it, and not all zero
  awk -F, -v most="$1" 'NR > 1 { for (i = NF - 1; i <= NF; i++) { e = $i < 0 ? -$i : $i; if (e > worst) worst = e } }
    END { print "largest error", worst; exit !(NR == 102 && worst < most && worst > 0) }' run.csv || fail "errors above $1 in run.csv"
}
for method in dop853 dp5 cvode_adams cvode_bdf arkode_fehlberg8; do
  grep -q "^  $method " <<<"$help" || continue # without SUNDIALS
  run 0 "$program" run $circle --method $method --rtol 1e-9 --atol 1e-9 --csv run.csv
  within 1e-5
done
run 0 "$program" run $circle --method rk4 --step 0.01 --csv run.csv
within 1e-6
says scratch/out.txt 'by rk4: 600 steps'
run 0 "$program" run $circle --method variational4 --step 0.01 --csv run.csv
within 1e-8
run 0 "$program" run $circle --t-end -6 --csv run.csv
within 1e-8

if grep -q '^  taylor ' <<<"$help"; then # a method that this model has no functions for
  run 1 "$program" run "$models/pendulum.so" --set n=1 --set g=9.81 --set mass=1 --set length=1 --method taylor --csv none.csv
  says scratch/err.txt 'taylor cannot follow this model like that; it is: .*need taylor'
  [ -e none.csv ] && fail "rows of a motion that never began"
  run 1 "$program" lyapunov "$models/pendulum.so" --set n=1 --set g=9.81 --set mass=1 --set length=1 --method taylor
  says scratch/err.txt '--method taylor: the model has no motion functions of the need taylor'
  run 0 "$program" lyapunov "$models/spring_pendulum.so" --set mass=1 --set rest=1 --set stiffness=40 --set gravity=9.81 --q 1,1 --t-end 20 \
    --method taylor --rtol 1e-15 --atol 1e-15
  says scratch/out.txt 'discrete, by taylor: 4 of 4'
  says scratch/out.txt 'largest .E - E0. +[0-9.]+e-1[3-9] J'
fi

# Events: y passes zero at pi rising down, at 2 pi up.
run 0 "$program" run $circle --t-end 7 --event 'q[1]' --event 'q[1] falling' --event 'q[1]-sin(1) rising stop' --events-csv events.csv --npz e.npz
says scratch/out.txt "The event 'q\[1\]-sin\(1\) rising stop' ended the motion"
awk -F, 'NR == 2 { exit !($1 == 2 && $2 > 0.999999999 && $2 < 1.000000001) }' events.csv || fail "not at t = 1: $(cat events.csv)"
run 0 "$program" run $circle --t-end 7 --event 'q[1]' --event 'q[1] falling' --event 'q[1] rising' --events-csv events.csv
awk -F, -v pi=3.14159265358979 '{ d = $2 - (NR < 4 ? pi : 2 * pi); n += NR > 1 && d * d < 1e-16; s = s $1 } END { exit !(n == 4 && s == "event0102") }' events.csv ||
  fail "not at pi and 2 pi: $(cat events.csv)"

# Two zeros in one long step: whatever changes its sign from row to row is an event. cos(20 t) does so 38 times in 6 s.
for method in dop853 taylor; do
  grep -q "^  $method " <<<"$help" || continue
  run 0 "$program" run $circle --method $method --event 'cos(20*t)' --event '0.99-q[0]^2' --events-csv events.csv
  awk -F, '{ seen[$1]++ } END { exit !(seen[0] == 38 && seen[1] == 3) }' events.csv || fail "by $method not 38 events and 3: $(cut -c 1-20 events.csv)"
done

run 1 "$program" run $circle --event 'q[0] stop' --event 'log(0.5-t)' --t-end 1
says scratch/err.txt "^eom: the event 'log\(0.5-t\)' is not a number at t = 0\.[5-9]"


# A start beside the constraints is brought onto them and stays there.
cat >chain.txt <<'EOF'
# Two rods in x and y
links = 2
coordinates = 4
g = 9.81        # m/s^2
mass = 1
length = 1
q = 1 0 2.1 0
qd[3] = -0.5
EOF
run 0 "$program" run "$models/cartesian_pendulum.so" --start chain.txt --t-end 2 --every 0.02 --csv run.csv --npz run.npz
says scratch/out.txt '^The start was brought onto the constraints: q\[2\] from 2.1 to '
says scratch/out.txt '^  largest \|phi\| +[0-9.]+e-1[0-9]$'
awk -F, 'NR == 2 { x = $4 - $2; exit !(x > 0.9999999999 && x < 1.0000000001) }' run.csv || fail "the second rod is not of length 1"
run 0 "$program" run "$models/cartesian_pendulum.so" --start chain.txt --t-end 2 --every 0.02 --no-projection --rtol 1e-4 --atol 1e-4
says scratch/out.txt '^  largest \|phi\| +[0-9.]+e-0[2-6]$'

# NPZ and CSV hold the same numbers, and do so again.
run 0 "$python" "$here/npz.py" run.npz
cp scratch/out.txt scratch/npz.txt
"$python" - <<'EOF' || fail "run.npz and run.csv differ"
import csv
rows = list(csv.reader(open("run.csv")))
names, numbers = rows[0], [[float(x) for x in row] for row in rows[1:]]
arrays = {name: (shape, [float(x) for x in values]) for name, shape, *values in (line.split() for line in open("scratch/npz.txt"))}
assert list(arrays) == ["t", "q", "qd", "energy", "energy_change", "phi", "phi_dot"], list(arrays)
assert arrays["q"][0] == "101x4" and arrays["t"][0] == "101"
assert names == ["t", "q[0]", "q[1]", "q[2]", "q[3]", "qd[0]", "qd[1]", "qd[2]", "qd[3]", "energy", "energy_change", "phi", "phi_dot"], names
at = 0
for shape, values in arrays.values():
    width = int(shape.split("x")[1]) if "x" in shape else 1
    assert values == [x for row in numbers for x in row[at : at + width]]
    at += width
EOF
run 0 "$program" run "$models/cartesian_pendulum.so" --start chain.txt --t-end 2 --every 0.02 --csv again.csv --npz again.npz
cmp run.csv again.csv && cmp run.npz again.npz || fail "the same run gives other bytes"

# The names of many curves stand beside them, not on them.
run 0 "$program" run "$models/pendulum.so" --set n=12 --set g=9.81 --set mass=1 --set length=1 --q "$(printf "0.1 %.0s" {1..12})" --t-end 0.5 --plot many.svg
"$python" - <<'EOF' || fail "names stand on the curves"
import re
texts = re.findall(r'translate\(([0-9.]+),[0-9.]+\)"[^>]*>\s*<text>(?:<tspan[^>]*>)?\s*([^<]*)', open("many.svg").read())
end = max(float(x) for x, text in texts if text == "0.5")
names = [(float(x), text) for x, text in texts if re.fullmatch(r"qd?\[\d+\]", text)]
assert len(names) == 24, texts
assert all(x - 7 * len(text) > end for x, text in names), (end, names) # to the right they end at x
EOF
