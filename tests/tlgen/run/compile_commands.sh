#!/usr/bin/env bash
# -p: the compiler arguments of a compilation database, with folders of its own, and those behind -- after them.
#   compile_commands.sh TLGEN
set -uo pipefail
tlgen=$1 here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
. "$here/expect.sh"
mkdir out src src/include build
echo '#define WEIGHT GRAVITY' >src/include/weight.h
cat >src/fall.c <<'END'
#include "weight.h"
double L(const double *q, const double *qd) { return 0.5 * qd[0] * qd[0] - WEIGHT * q[0]; }
#ifdef FAULT
double bad(const double *q, const double *qd) { return qd[0] * (int)q[0]; }
#endif
END
cat >build/compile_commands.json <<END
[{"directory": "$work/build", "file": "../src/fall.c",
  "command": "cc -I../src/include -DGRAVITY=9.75 -O2 -MD -MF fall.d -o fall.o -c ../src/fall.c"}]
END

expect 1 "weight.h" "$tlgen" src/fall.c --lagrangian L --dof 1 -o out/fall_tl.c
expect 0 "" "$tlgen" src/fall.c --lagrangian L --dof 1 -p build -MD -o out/fall_tl.c
grep -q '9\.75' out/fall_tl.c || { echo "-D of the database has no effect"; failed=1; }
grep -q 'weight\.h' out/fall_tl.c.d || { echo "the rule lacks weight.h"; failed=1; }
# Whatever the folder of the command, the rule's paths hold in the working directory.
for file in $(sed '1d; s/ \\$//' out/fall_tl.c.d); do [ -f "$file" ] || { echo "the rule names $file, which is not there"; failed=1; }; done
expect_files fall_tl.c fall_tl.h fall_tl.c.d
[ -z "$(ls build | grep -v compile_commands.json)" ] || { echo "a file in build"; failed=1; }

expect 1 "src/fall.c:4:64: error" "$tlgen" src/fall.c --lagrangian bad --dof 1 -p build -o out/fall_tl.c -- -DFAULT
expect 0 "" "$tlgen" src/fall.c --lagrangian L --dof 1 -p build -o out/fall_tl.c -- -UGRAVITY -DGRAVITY=1.25
grep -q '1\.25' out/fall_tl.c || { echo "arguments behind -- do not come after those of the database"; failed=1; }
exit $failed
