#!/usr/bin/env bash
# closed_form.sh PROGRAM: M, Q, A, b and the acceleration agree with the closed form at 1000 random states for W from 1e-8 to 1e8.
. "$(dirname "$0")/expect.sh"
for kinetic in full reduced; do
  run 0 "$1" --kinetic $kinetic --states 1000 --periods 0.1
  says scratch/out.txt '^Largest relative error at 1000 random states'
  line=$(grep -E '^ +M [0-9.e+-]+, Q ' scratch/out.txt) || fail "no errors are printed"
  echo "$kinetic: $line"
  tr ',' '\n' <<<"$line" | awk '{ if (!($2 <= 1e-13)) exit 1; n++ } END { exit n != 5 }' || fail "$kinetic: $line"
  for equation in 67 68 69 70 71; do says scratch/out.txt "eq $equation\$"; done
done
