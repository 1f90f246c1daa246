#!/usr/bin/env bash
# nonholonomic.sh PROGRAM MODELS: eom lyapunov where there is no Hamiltonian. Chaplygin's sleigh that glides straight ahead at v has, of its
# five exponents, one that is not zero, -m a v/(J + m a^2): energy is conserved, and nothing pairs.
. "$(dirname "$0")/../examples/expect.sh"
program=$1 models=$2
run 0 "$program" lyapunov "$models/chaplygin_sleigh.so" --set mass=2 --set inertia=0.5 --set ahead=0.5 --qd 3,0,0 --t-end 200
says scratch/out.txt '^  lambda_5 +-(3\.0000|2\.9999)[0-9]+ 1/s' # -2 0.5 3/(0.5 + 2 0.25)
says scratch/out.txt '^  second least \|lambda_i\| +[0-9.]+e[+-][0-9]+ 1/s$'
says scratch/out.txt '^  largest \|E - E0\| +[0-9.]+e[+-][0-9]+ J$'
grep -q partner scratch/out.txt && fail "exponents are paired that have no partner"
exit 0
