#!/usr/bin/env bash
# The firmware of examples/firmware on an emulated board: the poles stand at the end, numbers are those of the host's build of the same
# source, another run prints the same to the bit and the instruction. Ends with 77 where there is no cross compiler or no emulator.
#   firmware.sh TLGEN SOURCE-FOLDER POLES REAL BOARD
set -euo pipefail
tlgen=$1 root=$2 poles=$3 real=$4 board=$5
for tool in arm-none-eabi-gcc qemu-system-arm python3 make; do command -v $tool >/dev/null || { echo "no $tool here"; exit 77; }; done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
check() { python3 "$root/tests/embedded/firmware.py" "$@"; }
firmware() { make -s -C "$root/examples/firmware" TLGEN="$tlgen" OUT="$work" POLES="$poles" REAL="$real" "$@"; }

firmware BOARD="$board" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
if grep warning "$work/log"; then exit 1; fi
firmware derivatives >/dev/null
firmware BOARD="$board" run >"$work/board.csv"
firmware run >"$work/host.csv"
cd "$work"
check ends board.csv "$poles"
check ends host.csv "$poles"
check near board.csv host.csv
check states board.csv >states
"./derivatives-$poles-$real" <states >derivatives
check same board.csv derivatives
grep '^# longest' board.csv

# What is wrong is seen.
refuses() { ! check "$@" >/dev/null 2>&1 || { echo "not refused: $*"; exit 1; }; }
sed 's/,hold,/,swing,/' board.csv >wrong.csv
refuses ends wrong.csv "$poles"
sed 's/minus status 2/minus status 0/' board.csv >wrong.csv
refuses ends wrong.csv "$poles"
awk -F, -v OFS=, 'NR == 90 { $6 = $6 + 0.01 } 1' board.csv >wrong.csv
refuses near wrong.csv host.csv
awk 'NR == 90 { $1 = "0x1p+0" } 1' derivatives >wrong
refuses same board.csv wrong

if [ "$board" = m4f ]; then
  awk '/^# longest hold/ { found = $NF <= 168000 } END { exit !found }' board.csv || { echo "more than 168 MHz have at 1 kHz"; exit 1; }
  firmware BOARD="$board" run >again.csv
  cmp board.csv again.csv
fi
