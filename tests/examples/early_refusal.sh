#!/usr/bin/env bash
# early_refusal.sh WHAT OPTION.. -- PROGRAM OPTION..: before it computes, the program refuses an output of the kind WHAT (--csv, ..) that
# cannot be made. The run would take hours; nothing is left behind, and nothing that was there changes.
. "$(dirname "$0")/expect.sh"
files=()
while [ "$1" != -- ]; do files+=("$1") && shift; done
shift
mkdir held && echo before >held/a.svg
for file in "${files[@]}"; do
  for place in missing held/a.svg; do
    run 1 timeout -s KILL 20 "$@" $file $place/x.svg
    says scratch/err.txt "cannot (write|make the folder) '$place/x.svg"
    [ -s scratch/out.txt ] && fail "output though nothing can come of it"
    leaves held
  done
done
[ "$(ls held)$(cat held/a.svg)" = a.svgbefore ] || fail "what was there has changed"
