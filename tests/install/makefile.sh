#!/usr/bin/env bash
# makefile.sh EXAMPLES TREE PREFIX OPTION..: the example with a plain Makefile builds against an installed copy with the command that its
# first lines show; make does nothing the second time, runs tlgen again where a header of the model changed, and says what is missing. Of
# cmake's options the compiler and its flags are taken.
set -euo pipefail
examples=$1 tree=$2 prefix=$3
shift 3
settings=()
for option in "$@"; do
  case $option in
    -DCMAKE_C_COMPILER=*) settings+=("CC=${option#*=}") ;;
    -DCMAKE_C_FLAGS=*) settings+=("CFLAGS=${option#*=}") ;;
  esac
done
rm -rf "$tree"
mkdir -p "$tree"
cp -r "$examples/makefile" "$examples/models" "$tree"
cd "$tree/makefile"
pc=$(find "$prefix" -name libtaylor.pc -print -quit)
unset PKG_CONFIG_PATH TLGEN
settings+=("PKG_CONFIG_PATH=${pc%/*}")

build() { make --no-print-directory "${settings[@]}" >said 2>&1 || { cat said; exit 1; }; }
fail() { echo "$1"; cat said; exit 1; }

# refused TEXT SETTING..: make stops with this text before it does anything.
refused() {
  local text=$1
  shift
  make --no-print-directory "$@" >said 2>&1 && fail "make $* is content"
  grep -qF "$text" said || fail "make $* does not say: $text"
  [ -z "$(ls | grep -e '\.o$' -e _tl)" ] || fail "make $* leaves files: $(ls)"
}
export PKG_CONFIG_LIBDIR=
refused "say where it is, as in make PKG_CONFIG_PATH=PREFIX/lib/pkgconfig"
refused "say where it is, as in make PKG_CONFIG_PATH=PREFIX/lib/pkgconfig" PKG_CONFIG_PATH="$tree"
unset PKG_CONFIG_LIBDIR
refused "say where one is, as in make TLGEN=FOLDER/tlgen" "${settings[@]}" TLGEN=
make --no-print-directory clean >said 2>&1 || fail "make clean wants libtaylor"

build
./swing >printed
# M qdd = F by hand: M = [[5/3 + cos 0.5, 1/3 + cos(0.5)/2], [.., 1/3]], F = -9.81 (1.5 sin 1 + 0.5 sin 1.5, 0.5 sin 1.5).
python3 - >expected <<'END'
from math import cos, sin
a, b, d = 5 / 3 + cos(0.5), 1 / 3 + cos(0.5) / 2, 1 / 3
f, g = -9.81 * (1.5 * sin(1) + 0.5 * sin(1.5)), -9.81 * 0.5 * sin(1.5)
det = a * d - b * b
print(f"qdd[0] = {(d * f - b * g) / det:9.6f} rad/s^2")
print(f"qdd[1] = {(a * g - b * f) / det:9.6f} rad/s^2")
END
diff expected printed || exit 1

make --no-print-directory -q "${settings[@]}" || fail "the second make wants to do something"
build
grep -q tlgen said && fail "the second make runs tlgen"
sleep 0.01
touch ../models/double_pendulum.h
build
grep -q "tlgen .*double_pendulum" said || fail "a changed header does not run tlgen"
make --no-print-directory -q "${settings[@]}" || fail "make is not content after a change"
