#!/usr/bin/env bash
# libtaylor and the runtime's core as firmware has them: no memory of their own or from a heap, no stdio, no array of variable length, no
# recursion (through a pointer to a function, footprint.py looks for it in each image), no function beyond the mathematics, which one header
# can replace; in single precision no arithmetic in double, on a processor that would call a function for it. Ends with 77 where there is no cross compiler.
#   core.sh SOURCE-FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$1
command -v arm-none-eabi-gcc >/dev/null || { echo "no arm-none-eabi-gcc here"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mapfile -t sources < <(find "$root/libtaylor/src" "$root/runtime/src" -maxdepth 1 -name '*.c' ! -name '*_host.c' ! -name '*_lapacke.c' | sort)
[ ${#sources[@]} -gt 20 ]
failed=0

# What the objects may call: each other, the compiler's own helpers, five functions of string.h, and mathematics.
cat >"$work/mathematics" <<'M'
sqrt cbrt hypot pow exp exp2 expm1 log log2 log10 log1p sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh erf erfc tgamma
lgamma fabs floor ceil trunc round rint fmin fmax fdim fmod remainder copysign scalbn ldexp fma ilogb nearbyint frexp logb
M

compile() { # FOLDER TYPE FLAG.. SOURCE..
  local folder=$1 type=$2
  shift 2
  mkdir -p "$folder"
  (cd "$folder" && arm-none-eabi-gcc -std=c11 -O2 -DNDEBUG -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -DTL_REAL="$type" \
    -DTL_MAX_ORDER=2 -DTL_MAX_CURVE=2 -DTL_ALIGNMENT=8 -Wall -Wextra -Wconversion -Wdouble-promotion -Wfloat-conversion -Wvla -Werror \
    -fstack-usage -fcallgraph-info -I"$root/libtaylor/include" -I"$root/runtime/include" -c "$@")
}

# check FOLDER PREFIX SUFFIX: prints what may not be there. Mathematics is called as PREFIX name SUFFIX.
check() {
  local folder=$1 prefix=$2 suffix=$3
  arm-none-eabi-nm --defined-only "$folder"/*.o | awk 'NF == 3 { print $3 }' | sort -u >"$work/defined"
  arm-none-eabi-nm --undefined-only "$folder"/*.o | awk '$1 == "U" { print $2 }' | sort -u >"$work/called"
  tr ' ' '\n' <"$work/mathematics" | sed "s/.*/$prefix&$suffix/" >"$work/allowed"
  printf "%s\n" memcpy memmove memset memcmp strcmp >>"$work/allowed"
  comm -23 "$work/called" <(sort -u "$work/defined" "$work/allowed") | grep -v '^__aeabi_' | sed 's/^/calls /' || true
  [ "$suffix" != f ] || grep -E '^__aeabi_(d|[a-z0-9]+2d)' "$work/called" | sed 's/^/computes in double: /' || true
  arm-none-eabi-nm "$folder"/*.o | awk '$2 ~ /^[bBdDC]$/ { print "writable data: " $3 }'
  awk -F'\t' '$3 != "static" { print "frame of unknown size: " $1 }' "$folder"/*.su
  python3 "$here/recursion.py" "$folder"/*.ci
}

for type in FLOAT DOUBLE; do
  suffix=
  [ $type = DOUBLE ] || suffix=f
  compile "$work/$type" TL_$type "${sources[@]}"
  check "$work/$type" "" "$suffix" >"$work/said"
  ! grep . "$work/said" || failed=1
done

# The mathematics of somebody else.
{
  echo '#define HUGE_VAL __builtin_huge_val()'
  echo '#define NAN __builtin_nanf("")'
  echo '#define TL_LIBM(name) mine_##name'
  for name in $(cat "$work/mathematics"); do
    case $name in
      hypot | pow | atan2 | fmin | fmax | fdim | fmod | remainder | copysign) arguments='float, float' ;;
      scalbn | ldexp) arguments='float, int' ;;
      frexp) arguments='float, int *' ;;
      fma) arguments='float, float, float' ;;
      *) arguments=float ;;
    esac
    [ "$name" = ilogb ] && echo "int mine_$name(float);" || echo "float mine_$name($arguments);"
  done
} >"$work/mine.h"
compile "$work/mine" TL_FLOAT "-DTL_MATH_HEADER=\"$work/mine.h\"" "${sources[@]}"
check "$work/mine" mine_ "" >"$work/said"
! grep . "$work/said" || failed=1

# Each of these is seen.
notices() { # TEXT TYPE C
  mkdir -p "$work/canary"
  rm -f "$work/canary"/*
  printf '%s\n' "$3" >"$work/canary/canary.c"
  (cd "$work/canary" && arm-none-eabi-gcc -std=c11 -O2 -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -fstack-usage -fcallgraph-info -c canary.c)
  check "$work/canary" "" "$2" >"$work/noticed" && grep -q "$1" "$work/noticed" || { echo "goes unseen: $3"; failed=1; }
}
notices 'calls malloc' '' '#include <stdlib.h>
void *canary(void) { return malloc(8); }'
notices 'calls printf\|calls puts\|calls iprintf' '' '#include <stdio.h>
int canary(int x) { return printf("%d", x); }'
notices 'writable data' '' 'static int calls; int canary(void) { return ++calls; }'
notices 'frame of unknown size' '' 'int canary(int n) { volatile char x[n]; x[0] = 1; return x[0]; }'
notices 'circle of calls' '' '__attribute__((noinline)) int canary(int n) { volatile int m = n; return m > 0 ? canary(m - 1) + m : 0; }'
notices 'circle of calls' '' '__attribute__((noinline)) static int other(int); __attribute__((noinline)) int canary(int n) { volatile int m = n; return m > 0 ? other(m - 1) + m : 0; }
static int other(int n) { return n > 3 ? canary(n) + 1 : 7; }'
notices 'computes in double' f 'float canary(float x) { return (float)(x * 0.1); }'
exit $failed
