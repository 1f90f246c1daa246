#!/usr/bin/env bash
# What a test program says to wrong and missing parameters, points and options.
#   usage.sh HABITS HABITS.TXT SCALARS    two programs, and points of the first
set -uo pipefail
habits=$1 text=$2 scalars=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
failed=0
expect() {
  local status=$1 wanted=$2 got=0
  shift 2
  "$@" >said 2>&1 || got=$?
  if [ $got != "$status" ] || [[ "$(cat said)" != *"$wanted"* ]]; then
    echo "$*: exit status $got, not $status, or not: $wanted"
    cat said
    failed=1
  fi
}
point="q=0.3,0.4 qd=-1.5,0.25 t=2"
params=$(sed -n 's/^params //p' "$text" | tr '\n' ' ')

expect 2 'habits_selftest --params "exp=1.5,1.5,1.5,.. rows=2' "$habits"
expect 2 "no point is given" "$scalars"
expect 2 "parameter 'single' is missing" "$habits" --params "${params/single=0.1/}" --point "$point"
expect 2 "no member 'mass'" "$habits" --params "mass=1" --point "$point"
expect 2 "'rows' is given twice" "$habits" --params "$params rows=2" --point "$point"
expect 2 "parameter 'exp' has 6 numbers, not 5" "$habits" --params "${params/,6/}" --point "$point"
expect 2 "rows: '3x' is not an integer" "$habits" --params "${params/rows=3/rows=3x}" --point "$point"
expect 2 "rows: '300' is not an integer of its type" "$habits" --params "${params/rows=3/rows=300}" --point "$point"
expect 2 "rows: '-1' is not an integer of its type" "$habits" --params "${params/rows=3/rows=-1}" --point "$point"
expect 2 "single: 'x' is not a number" "$habits" --params "${params/single=0.1/single=x}" --point "$point"
expect 2 "'5' has no name" "$habits" --params "5 $params" --point "$point"
expect 2 "the model has no parameters" "$scalars" --params "a=1" --point "$point"
expect 2 "point 1: t is missing" "$scalars" --point "q=0.3,0.4 qd=-1.5,0.25"
expect 2 "point 2: qd is missing" "$scalars" --point "$point" --point "q=0.3,0.4 t=1"
expect 2 "point 1: q has 2 numbers, not 3" "$scalars" --point "q=0.3,0.4,1 qd=-1.5,0.25 t=1"
expect 2 "'x' is none of q, qd and t" "$scalars" --point "x=1"
expect 2 "cannot read missing" "$scalars" missing
echo "q=1" >list
expect 2 "list:1: a line begins with" "$scalars" list
expect 2 "--colour is no option" "$scalars" --colour red
expect 2 "--order is no option, or its value is out of range" "$scalars" --point "$point" --order 4
expect 2 "--point wants a value" "$scalars" --point
expect 2 "parameter 'exp' has 6 numbers, not 7" "$habits" --params "${params/5,6/5,6,7,..}" --point "$point"
expect 0 "All derivatives agree" "$habits" --params "${params/5,6/5,..}" --point "q=0.3,.. qd=-1.5,0.25 t=2" --order 1
expect 0 "usage: habits_selftest" "$habits" --help
expect 0 "part[1].rest" "$habits" --list
expect 0 "All derivatives agree" "$scalars" --point "$point" --order 1
[ "$(grep -c '^lagrangian' said)" = 2 ] || { echo "--order 1 does not end with order 1"; cat said; failed=1; }
expect 1 "WRONG" "$scalars" --point "$point" --rtol 0
expect 1 "unsettled" "$scalars" --point "$point" --step 0.5
exit $failed
