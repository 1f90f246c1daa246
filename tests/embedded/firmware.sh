#!/usr/bin/env bash
# The firmware of examples/firmware on an emulated board: the poles swing up and stand at the end, what goes wrong is told by a status and
# survived, and every number is that of the host's build of the same source, to the bit. Ends with 77 where there is no cross compiler or
# no emulator.
#   firmware.sh SOURCE-FOLDER FOLDER POLES REAL BOARD      FOLDER: as firmware_build.sh has left it
set -euo pipefail
root=$1 built=$2 poles=$3 real=$4 board=$5
for tool in arm-none-eabi-gcc qemu-system-arm python3 make; do command -v $tool >/dev/null || { echo "no $tool here"; exit 77; }; done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
check() { python3 "$root/tests/embedded/firmware.py" "$@"; }
firmware() { make -s -C "$root/examples/firmware" TLGEN=false OUT="$built" POLES="$poles" REAL="$real" "$@"; }

firmware BOARD="$board" run >"$work/board.csv"
firmware run >"$work/host.csv"
cd "$work"
check ends board.csv
check same board.csv host.csv
grep 'of the longest' board.csv

# What is wrong is seen.
refuses() { ! check "$@" >/dev/null 2>&1 || { echo "not refused: $*"; exit 1; }; }
sed 's/,hold,/,swing,/' board.csv >wrong.csv
refuses ends wrong.csv
sed 's/minus status 2/minus status 0/' board.csv >wrong.csv
refuses ends wrong.csv
awk -F, -v OFS=, 'NR == 90 { $NF = "0" substr($NF, 2) } 1' board.csv >wrong.csv
refuses same wrong.csv host.csv
refuses same host.csv host.csv # an emulated board counts its instructions

if [ "$board" = m4f ]; then
  awk '/^# hold, instructions of the longest/ { found = $NF <= 168000 } END { exit !found }' board.csv || { echo "more than 168 MHz have at 1 kHz"; exit 1; }
fi
if [ "$board" = m4f ] && [ "$poles" = 1 ]; then
  firmware BOARD="$board" run >again.csv
  cmp board.csv again.csv
fi
