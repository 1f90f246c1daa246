#!/usr/bin/env bash
# Accelerations and linearisation of the cart with poles in single precision against those in double, at 10000 random states; and the
# regulator's gain in both against the Riccati recursion in long double.
#   precision.sh TLGEN SOURCE-FOLDER POLES
set -euo pipefail
tlgen=$1 root=$2 poles=$3
for tool in python3 make; do command -v $tool >/dev/null || { echo "no $tool here"; exit 77; }; done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
check() { python3 "$root/tests/embedded/firmware.py" "$@"; }
check random 10000 1 "$poles" >"$work/states"
for real in float double; do
  make -s -C "$root/examples/firmware" TLGEN="$tlgen" OUT="$work" POLES="$poles" REAL=$real derivatives >/dev/null
  "$work/derivatives-$poles-$real" <"$work/states" >"$work/$real"
  export=$(echo "$work/"*cart_pole-$real)
  cc -std=c11 -O2 -DPLANT_POLES="$poles" -I"$root/examples/firmware" -I"$export" -I"$export/include" "$root/tests/embedded/riccati.c" \
    "$root/examples/firmware/riccati.c" "$root/examples/firmware/plant.c" "$export/"*_tl.c "$export/src/"*.c -lm -o "$work/riccati"
  "$work/riccati"
done
check precision "$work/float" "$work/double"
awk 'NR == 5000 { $1 = $1 "1" } 1' "$work/float" >"$work/wrong"
! check precision "$work/wrong" "$work/double" >/dev/null 2>&1 || { echo "a wrong number goes unseen"; exit 1; }
