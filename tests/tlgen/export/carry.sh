#!/usr/bin/env bash
# An export carries the file with a function's rule, and what of libtaylor that needs: it then computes what it does where tlgen has that
# function's C. Without the rule, or with files that cannot be carried, there is no export.
#   carry.sh TLGEN
set -euo pipefail
tlgen=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "$*"; exit 1; }
body='double L(const double *q, const double *qd) { return 0.5 * (2.0 + cos(q[1])) * (qd[0] * qd[0] + qd[1] * qd[1]) - spring(q[1]) - q[0] * q[0]; }'
printf '#include <math.h>\ndouble spring(double x);\n%s\n' "$body" >rule.c
printf '#include <math.h>\nstatic double spring(double x) { return exp(-x); }\n%s\n' "$body" >plain.c
mkdir mine
cat >mine/spring.c <<'C'
#include "spring.h"

unsigned spring_taylor(tl_real *f, tl_real x, int degree, const void *user) {
  (void)user;
  f[tl_rule_index(1, &(int){0})] = TL_LIBM(exp)(-x);
  for (int k = 1; k <= degree; k++) f[k] = -f[k - 1] / (tl_real)k;
  return TL_OK;
}
C
printf '#include <taylor/rule.h>\ntl_rule spring_taylor;\n' >mine/spring.h
with=(rule.c --lagrangian L --dof 2 --rule spring:spring_taylor)

refused() { # TEXT ARGUMENT..
  local text=$1
  shift
  ! "$tlgen" "$@" 2>said || fail "not refused: $*"
  grep -qF -- "$text" said || { cat said; fail "does not say '$text'"; }
  [ ! -e out ] || fail "a refused export leaves a folder"
}
refused "--carry names the file that defines its rule spring_taylor" "${with[@]}" --export out
refused "--carry names the file that defines its rule spring_taylor" "${with[@]}" --export out --carry mine/spring.h
refused 'mine/none.c cannot be read' "${with[@]}" --export out --carry mine/none.c
refused 'mine cannot be read' "${with[@]}" --export out --carry mine
refused '--carry belongs to --export' "${with[@]}" --carry mine/spring.c
cp mine/spring.c mine/main.c
refused 'already a file of the name main.c' "${with[@]}" --export out --carry mine/main.c
refused 'already a file of the name spring.c' "${with[@]}" --export out --carry mine/spring.c --carry mine/spring.c

for real in float double; do
  "$tlgen" plain.c --model rule --lagrangian L --dof 2 --export plain --real $real
  "$tlgen" "${with[@]}" --carry mine/spring.c --carry mine/spring.h --export out --real $real
  grep -q 'rule_tl.c spring.c' out/CMakeLists.txt || fail "CMakeLists.txt leaves the rule out"
  for folder in plain out; do
    compile=$(sed -n 's/^compile: cc //p' $folder/MANIFEST)
    (cd $folder && eval "cc -Wall -Wextra -Wconversion -Wdouble-promotion -Wpedantic -Werror $compile" && ./example >../$folder.said && rm example)
  done
  cmp plain.said out.said
done
