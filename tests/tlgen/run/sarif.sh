#!/usr/bin/env bash
# --sarif: all messages of a run in a file of version 2.1.0, with and without errors, the same each time, or no file at all.
#   sarif.sh TLGEN sarif.py
set -uo pipefail
tlgen=$1 check=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
. "$(dirname "$check")/expect.sh"
mkdir out "a folder"
echo 'double L(const double *q, const double *qd) { return qd[0] * qd[0] - q[0]; }' >good.c
cat >"a folder/bad.c" <<'END'
static double count;
double L(const double *q, const double *qd)
{
  count += 1.0;
  return qd[0] * (int)q[0];
}
END
options=(--lagrangian L --dof 1 -o out/m.c --model m)

# results TEXT FILE: the file holds exactly these results.
results() {
  local found
  found=$(python3 "$check" "$2") || failed=1
  [ "$found" = "$1" ] || { echo "$2: results: $found"; echo "expected: $1"; failed=1; }
}

expect 0 "" "$tlgen" good.c "${options[@]}" --sarif out/m.sarif
results "" out/m.sarif
expect_files m.c m.h m.sarif

expect 1 "a folder/bad.c:4:3: error" "$tlgen" "a folder/bad.c" "${options[@]}" --sarif out/m.sarif
results "error global-state a folder/bad.c 4 3" out/m.sarif
cp out/m.sarif first.sarif
expect_files m.sarif
expect 1 "error" "$tlgen" "a folder/bad.c" "${options[@]}" --sarif out/m.sarif
cmp out/m.sarif first.sarif || failed=1
expect_files m.sarif

expect 1 "[no-function]" "$tlgen" good.c --lagrangian M --dof 1 --sarif out/m.sarif
results "error no-function good.c" out/m.sarif
expect_files m.sarif

# A warning is told and lets the run pass; with --werror it is an error.
printf '#include <math.h>\n%s\n' 'double L(const double *q, const double *qd) { return qd[0] * qd[0] - floor(q[0]); }' >steps.c
expect 0 "steps.c:2:70: warning: 'floor': " "$tlgen" steps.c "${options[@]}" --sarif out/m.sarif
results "warning zero-derivative steps.c 2 70" out/m.sarif
expect_files m.c m.h m.sarif
expect 1 "steps.c:2:70: error: 'floor': " "$tlgen" steps.c "${options[@]}" --sarif out/m.sarif --werror
results "error zero-derivative steps.c 2 70" out/m.sarif
expect_files m.sarif
expect 0 "" "$tlgen" good.c "${options[@]}" --werror
expect_files m.c m.h

expect 1 "cannot write missing/m.sarif" "$tlgen" good.c "${options[@]}" --sarif missing/m.sarif
expect_files
expect 2 "good.c is a source" "$tlgen" good.c "${options[@]}" --sarif good.c
expect 2 "would be written twice" "$tlgen" good.c "${options[@]}" --sarif out/../out/m.h
expect_files
exit $failed
