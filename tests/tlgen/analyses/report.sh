#!/usr/bin/env bash
# The report of motion functions: what it says of models where that is known, and that the form that is taken is the cheaper one.
#   report.sh TLGEN MODELS MECHANICS    folders of sources
set -euo pipefail
tlgen=$1 models=$2 mechanics=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

report() { "$tlgen" "$@" -o "$work/model_tl.c" 2> "$work/notes" || { cat "$work/notes"; exit 1; }; }
expect() { # TEXT TEXT_THAT_IT_HOLDS
  grep -qE -- "$2" <<< "$1" || { echo "no '$2' in:"; echo "$1"; status=1; }
}

pendulum=("$models/pendulum.c" --lagrangian pendulum_lagrangian --dof n --size n=6 --need all --parameter mass)
chain=("$mechanics/fput.c" --lagrangian fput_lagrangian --arg p=chain --dof nr_masses --size nr_masses=5)
hoop=("$mechanics/rotating_hoop.c" --lagrangian bead_on_hoop --dof 1)

text=$(report "${pendulum[@]}" --report)
expect "$text" "t occurs in no equation"
expect "$text" "M depends on the state"
expect "$text" "^ +M +0 +1 +0 +5 +21 +36$" # the upper triangle
text=$(report "${chain[@]}" --report --form rows)
expect "$text" "M depends on parameters alone"
expect "$text" "^ +M +0 +5 +0 +0 +5 +25$" # the diagonal
expect "$text" "rows +asked for"
text=$(report "${hoop[@]}" --report --without constant-mass)
expect "$text" "t occurs in the equations"
expect "$text" "M: not looked at"
expect "$text" "Without constant-mass:"

# Each line of the table has all columns; of both forms the one with the smaller estimate is taken; other constants, other forms.
report "${pendulum[@]}" --report=csv > "$work/report.csv"
awk -F, 'NR == 1 { columns = NF; next }
  NF != columns { print "a line of " NF " columns: " $0; bad = 1 }
  { if ($4 == "not taken") other[$2] = $NF; else taken[$2] = $NF }
  END { for (f in taken) if (taken[f] > other[f]) { print f " has the slower form"; bad = 1 }
        if (length(taken) != 9) { print length(taken) " functions"; bad = 1 }
        exit bad }' "$work/report.csv" || status=1
for costs in "rows vector=0,repeated=0,iteration=0,form=0" "registers operation=0,vector=9"; do
  report "${pendulum[@]}" --report=csv --cost "${costs#* }" > "$work/report.csv"
  expect "$(grep -v 'not taken' "$work/report.csv")" "jacobian,${costs%% *},estimated"
done
exit $status
