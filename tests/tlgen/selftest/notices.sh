#!/usr/bin/env bash
# A test program notices a wrong value, a wrong derivative of each order, a kink and a pole.
#   notices.sh TLGEN INCLUDE.. -- LIBRARY..
set -uo pipefail
tlgen=$1
shift
includes=()
while [ "$1" != -- ]; do includes+=(-I"$1"); shift; done
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cat >model.c <<'END'
#include <math.h>
double L(const double *q, const double *qd) { return qd[0] * qd[0] * sin(q[0]) + sqrt(q[0]); }
double kink(const double *q) { return q[0] > 1.0 ? q[0] * q[0] : q[0]; }
END
failed=0
libraries=("$@")

# try STATUS TEXT POINT [SED]: the test of the model, whose generated C is changed by SED, ends so.
try() {
  local got=0
  "$tlgen" model.c --lagrangian L --holonomic kink --dof 1 --selftest || exit 1
  [ $# -lt 4 ] || { sed "$4" model_tl.c >changed.c && ! cmp -s changed.c model_tl.c && mv changed.c model_tl.c; } || { echo "$4 changes nothing"; failed=1; }
  gcc -std=gnu11 ${CFLAGS-} "${includes[@]}" model_tl.c model_selftest.c "${libraries[@]}" -lquadmath -lm -o test || exit 1
  ./test --point "$3" >said 2>&1 || got=$?
  if [ $got != "$1" ] || ! grep -qE -- "$2" said; then
    echo "point $3, ${4-unchanged}: exit status $got, not $1, or not: $2"
    cat said
    failed=1
  fi
}
try 0 "^All derivatives agree" "q=0.5 qd=2"
try 1 "^L +0 .*WRONG" "q=0.5 qd=2" 's/tl_sin(/tl_cos(/'
try 1 "^L +1 .*WRONG" "q=0.5 qd=2" 's/  tl_mul(cx, tmp\([0-9]\), qd, qd);/  tl_mul(cx, tmp\1, qd, qd); tmp\1[2] += 1e-9;/'
try 1 "^L +2 .*WRONG" "q=0.5 qd=2" 's/  tl_mul(cx, tmp\([0-9]\), qd, qd);/  tl_mul(cx, tmp\1, qd, qd); if (nc > 5) tmp\1[8] += 1e-9;/'
try 1 "^L +3 .*WRONG" "q=0.5 qd=2" 's/  tl_mul(cx, tmp\([0-9]\), qd, qd);/  tl_mul(cx, tmp\1, qd, qd); if (nc > 10) tmp\1[19] += 1e-9;/'
try 1 "^kink.* unsettled" "q=1.00001 qd=2"
try 1 "^L \(model.c:2\), point 1: .* in sqrt, line 2" "q=0 qd=2"
exit $failed
