#!/usr/bin/env bash
# Accelerations and linearisation of the cart with poles in single precision against those in double, at 10000 random states; and the
# regulator's gain in both against the Riccati recursion in long double.
#   precision.sh SOURCE-FOLDER FOLDER POLES      FOLDER: as firmware_build.sh has left it
set -euo pipefail
root=$1 built=$2 poles=$3
[ -x "$built/2-float-host" ] || { echo "no firmware here"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
check() { python3 "$root/tests/embedded/firmware.py" "$@"; }
check random 10000 1 "$poles" >"$work/states"
for real in float double; do
  "$built/derivatives-$poles-$real" <"$work/states" >"$work/$real"
  export=$built/$([ "$poles" = 1 ] && echo cart_pole || echo double_cart_pole)-$real
  cc -std=c11 -O2 -DPLANT_POLES="$poles" -I"$root/examples/firmware" -I"$export" -I"$export/include" "$root/tests/embedded/riccati.c" \
    "$root/examples/firmware/riccati.c" "$root/examples/firmware/plant.c" "$export/"*_tl.c -lm -o "$work/riccati"
  "$work/riccati"
done
check precision "$work/float" "$work/double"
awk 'NR == 5000 { $1 = $1 "1" } 1' "$work/float" >"$work/wrong"
! check precision "$work/wrong" "$work/double" >/dev/null 2>&1 || { echo "a wrong number goes unseen"; exit 1; }
