#!/usr/bin/env bash
# Builds the firmware of examples/firmware once for all its tests: for the host and, where there is a cross compiler, for boards.
#   firmware_build.sh TLGEN SOURCE-FOLDER FOLDER
set -euo pipefail
tlgen=$1 root=$2 work=$3
for tool in python3 make; do command -v $tool >/dev/null || { echo "no $tool here"; exit 77; }; done
rm -rf "$work"
mkdir -p "$work"
firmware() { make -s -C "$root/examples/firmware" TLGEN="$tlgen" OUT="$work" "$@"; }
{
  for poles in 1 2; do
    for real in float double; do firmware POLES=$poles REAL=$real && firmware POLES=$poles REAL=$real derivatives; done
  done
  firmware POLES=2 REAL=double "$work/plan"
  if command -v arm-none-eabi-gcc; then
    for poles in 1 2; do
      firmware POLES=$poles REAL=float BOARD=m4f
      firmware POLES=$poles REAL=float BOARD=m3
      firmware POLES=$poles REAL=double BOARD=m7
    done
  fi
} >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
if grep warning "$work/log"; then exit 1; fi
