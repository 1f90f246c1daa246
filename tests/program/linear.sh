#!/usr/bin/env bash
# linear.sh PROGRAM MODELS PYTHON DRIVEN: eom linearise against closed forms: the double pendulum of unit masses and rods, hanging, in angles and,
# with constraints, in x and y: s = +- i sqrt(g (2 +- sqrt 2)).
. "$(dirname "$0")/../examples/expect.sh"
here=$(cd "$(dirname "$0")" && pwd) program=$1 models=$2 python=$3 driven=$4
unit="--set g=9.81 --set mass=1 --set length=1"
frequencies() { # of modes.csv, against the closed form
  "$python" - "$@" <<'EOF' || fail "the modes of modes.csv are not those of the double pendulum"
import csv, math
rows = [[float(x) for x in row] for row in list(csv.reader(open("modes.csv")))[1:]]
wanted = [math.sqrt(9.81 * (2 - math.sqrt(2))), math.sqrt(9.81 * (2 + math.sqrt(2)))]
assert len(rows) == 4
for row, w in zip(rows, [wanted[0], -wanted[0], wanted[1], -wanted[1]]):
    assert abs(row[0]) < 1e-12 and abs(row[1] - w) < 1e-12 and abs(row[2] - abs(w) / (2 * math.pi)) < 1e-12, row
EOF
}
run 0 "$program" linearise "$models/pendulum.so" --set n=2 $unit --csv F.csv --modes-csv modes.csv
grep -q 'no equilibrium' scratch/out.txt && fail "the hanging pendulum is an equilibrium"
frequencies
tail -n 2 F.csv | "$python" -c '
import sys
rows = [[float(x) for x in line.split(",")] for line in sys.stdin]
g = 9.81
wanted = [[-2 * g, g, 0, 0], [2 * g, -2 * g, 0, 0]]
sys.exit(any(abs(x - y) > 1e-12 for a, b in zip(rows, wanted) for x, y in zip(a, b)))' || fail "F.csv is not [0 1; -2g g; 2g -2g]"

# From a state near it, and with constraints.
run 0 "$program" linearise "$models/pendulum.so" --set n=2 $unit --q 0.2,-0.1 --equilibrium --modes-csv modes.csv
frequencies
run 0 "$program" linearise "$models/cartesian_pendulum.so" --set links=2 --set coordinates=4 $unit --q 0.1,-1,0,-2.1 --equilibrium \
  --modes-csv modes.csv --npz all.npz
says scratch/out.txt '^Equilibrium after'
frequencies
run 0 "$python" "$here/npz.py" all.npz
for array in 'q 4' 'qdd 4' 'F 4x4' 'eigenvalues 4x2' 'shapes 4x2x8' 'Z 8x4' 'S 4x8'; do says scratch/out.txt "^$array "; done

run 0 "$program" linearise "$models/pendulum.so" --set n=2 $unit --q 75deg,0
says scratch/out.txt 'It is no equilibrium'
run 1 "$program" linearise "$models/cart_pole.so" --set cart_mass=1 --set pole_mass=0.1 --set pole_length=1 --set gravity=9.81 --set push=1 --equilibrium
says scratch/err.txt 'no equilibrium'
says scratch/err.txt '^eom: nothing near this state holds q\[0\]$'
run 1 "$program" linearise "$models/kepler.so" --q 1,0 --qd 0,1.5 --equilibrium
says scratch/err.txt '^eom: nothing near this state holds q\[[01]\] at the velocities given, which --equilibrium leaves as they are \(qd\[1\] = 1\.5\)'

# An equilibrium that time moves on from: q'' = -(g - 10 sin(5 t)) sin q, at t = 0.1 s.
run 0 "$program" linearise "$driven" --q 0.1 --t0 0.1 --equilibrium --csv F.csv
says scratch/out.txt '^Time moves this model: .* the modes are those of the instant\.$'
tail -n 1 F.csv | awk -F, '{ d = $1 + 9.81 - 10 * sin(0.5); exit !(d < 1e-12 && d > -1e-12) }' || fail "not -(g - 10 sin 0.5): $(tail -n 1 F.csv)"
run 0 "$program" linearise "$models/pendulum.so" --set n=2 $unit
grep -q 'Time moves' scratch/out.txt && fail "time moves a pendulum whose Lagrangian has none"
exit 0
