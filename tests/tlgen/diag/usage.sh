#!/usr/bin/env bash
# The command line of tlgen: wrong usage, help, unreadable sources and outputs that cannot be written.
#   usage.sh TLGEN
set -uo pipefail
tlgen=$1
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
cd "$work"
echo 'double L(const double *q, const double *qd) { return qd[0] * qd[0] - q[0]; }' >model.c
good=(model.c --lagrangian L --dof 1)
failed=0

# expect STATUS TEXT COMMAND..: the command ends with that status, says TEXT, and leaves no file beside model.c.
expect() {
  local status=$1 text=$2 got=0
  shift 2
  "$@" >said 2>&1 || got=$?
  if [ $got != "$status" ] || ! grep -qF -- "$text" said; then
    echo "$*: exit status $got, not $status, or not: $text"
    cat said
    failed=1
  fi
  rm -f said
  local left
  left=$(find . -type f ! -name model.c ! -path './kept/*')
  [ -z "$left" ] || { echo "$*: left behind: $left"; failed=1; rm -f $left; }
}

expect 2 "no source file" "$tlgen"
expect 2 "unknown option '--colour'" "$tlgen" "${good[@]}" --colour red
expect 2 "compiler arguments belong behind '--'" "$tlgen" "${good[@]}" -I../x -- -DX
expect 2 "--dof wants a value" "$tlgen" model.c --lagrangian L --dof
expect 2 "--dof is given twice" "$tlgen" "${good[@]}" --dof 2
expect 2 "--model is empty" "$tlgen" "${good[@]}" --model=
expect 2 "'nine' is no role" "$tlgen" "${good[@]}" --arg nine=x
expect 2 "--arg wants ROLE=NAME" "$tlgen" "${good[@]}" --arg q
expect 2 "has two roles" "$tlgen" "${good[@]}" --arg q=x --arg qd=x
expect 2 "cannot be a model's name" "$tlgen" "${good[@]}" --model 2nd
expect 2 "must end in .c" "$tlgen" "${good[@]}" -o model.h
expect 2 "would be overwritten" "$tlgen" "${good[@]}" -o model.c
expect 2 "would be overwritten" "$tlgen" "${good[@]}" -o ./model.c
expect 2 "would be overwritten" "$tlgen" "${good[@]}" -o "$work/model.c"
expect 2 "no message has the id 'nonsense'" "$tlgen" --explain nonsense
expect 2 "'speed' is no need" "$tlgen" "${good[@]}" --need speed
expect 2 "--need wants a list" "$tlgen" "${good[@]}" --need ,
expect 2 "--size wants MEMBER=N" "$tlgen" "${good[@]}" --size 6
expect 2 "--size wants MEMBER=N" "$tlgen" "${good[@]}" --size n=0
expect 2 "'n' has two sizes" "$tlgen" "${good[@]}" --size n=6 --size n=7
expect 2 "--parameter wants names" "$tlgen" "${good[@]}" --parameter ,mass
expect 2 "wants --parameter" "$tlgen" "${good[@]}" --need parameters
expect 2 "'columns' is no form" "$tlgen" "${good[@]}" --form columns
expect 2 "'activty' is no analysis; the analyses are activity, demand" "$tlgen" "${good[@]}" --without activty
expect 2 "'speed' is no constant; the constants are operation" "$tlgen" "${good[@]}" --cost speed=1
expect 2 "'-1' is no time in nanoseconds" "$tlgen" "${good[@]}" --cost vector=-1
expect 2 "'xml' is no format" "$tlgen" "${good[@]}" --report=xml
expect 1 "[no-file]" "$tlgen" missing.c --lagrangian L --dof 1
expect 1 "[no-file]" "$tlgen" . --lagrangian L --dof 1 --model m -o m.c
expect 1 "[no-file]" "$tlgen" "${good[@]}" -p missing
expect 1 "cannot write missing/out.c" "$tlgen" "${good[@]}" -o missing/out.c
expect 1 "Add --lagrangian NAME" "$tlgen" model.c --dof 1
expect 1 "Add LAGRANGIAN NAME" "$tlgen" model.c --dof 1 --cmake
expect 0 "usage: tlgen" "$tlgen" --help
expect 0 "built with LLVM and Clang" "$tlgen" --version
expect 0 "--models FILE" "$tlgen" --help
expect 0 "active-integer (error)" "$tlgen" --explain active-integer
expect 0 "pointer-cast: " "$tlgen" --explain

# A disk that is full: nothing is left, and files that were there keep their contents.
mkdir kept
echo "old" >kept/out.c
expect 1 "nothing was changed" bash -c 'ulimit -f 1; exec "$@"' - "$tlgen" "${good[@]}" -o kept/out.c
[ "$(cat kept/out.c)" = old ] && [ "$(ls kept)" = out.c ] || { echo "a full disk changed what was there: $(ls kept)"; failed=1; }

# A folder that may not be written to, which root may.
chmod a-w kept
if [ "$(id -u)" != 0 ]; then
  expect 1 "cannot write kept/new.c" "$tlgen" "${good[@]}" -o kept/new.c
fi
exit $failed
