#!/usr/bin/env bash
# libtaylor and its header-only kernels in single precision do no arithmetic in double: the compiler promotes no float, and on x86-64 no
# instruction converts to double or computes in it. Usage: single.sh COMPILER LIBTAYLOR-FOLDER
set -euo pipefail
compiler=$1 folder=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf '#include "taylor/%s"\n' taylor.h row.h power.h finite.h ldl.h sincos_array.h >"$work/kernels.c"
cat >>"$work/kernels.c" <<'C'
tl_real solve(tl_real *x, tl_real *w, tl_real *d, const tl_real *b) { return tl_ldl_factor_solve(3, x, w, TL_LDL_ROW(3), d, b); }
tl_real power(tl_real x, tl_real e) { return tl_power_exists(x, e, 2) ? tl_power(x, e, 2) : TL_C(0.0); }
int row(tl_real *d, const tl_real *x, tl_real m, int n) { tl_row_add_prefix(d, x, m, n); return tl_finite_array(n, d); }
void sincos_of(const tl_real *x, tl_real *s, tl_real *c, int n) { tl_sincos_array(n, x, s, c); }
C
objects=()
for source in "$folder"/src/*.c "$work/kernels.c"; do
  object=$work/$(basename "$source" .c).o
  "$compiler" -std=c11 -O2 -DNDEBUG -DTL_REAL=TL_FLOAT -Wdouble-promotion -Werror -I"$folder/include" -c "$source" -o "$object"
  objects+=("$object")
done
[ "$(uname -m)" = x86_64 ] || exit 0

# in_double OBJECT..: the instructions that convert to double or compute in it.
in_double() {
  objdump --disassemble --no-show-raw-insn "$@" |
    grep -E '\sv?(cvt\w*(sd|pd)\w*|(add|sub|mul|div|sqrt|u?comi|max|min)(sd|pd)|fn?m(add|sub)\w*(sd|pd))\s'
}
echo 'float tenth(float x) { return (float)(x * 0.1); }' >"$work/canary.c"
"$compiler" -O2 -c "$work/canary.c" -o "$work/canary.o"
in_double "$work/canary.o" >/dev/null || { echo "a product in double goes unseen"; exit 1; }
if in_double "${objects[@]}"; then
  echo "arithmetic in double"
  exit 1
fi
