#!/usr/bin/env bash
# regenerate.sh SOURCE TREE OPTION..: a change in a header that a model includes changes the program; no change, no work.
set -euo pipefail
here=$(dirname "$0") source=$1 tree=$2
shift 2
rm -rf "$tree.copy"
cp -r "$source" "$tree.copy"

expect() {
  [ "$2" = "$3" ] || { echo "$1: got \"$2\", expected \"$3\""; exit 1; }
}
expect "first build" "$(bash "$here/build_and_run.sh" "$tree.copy" "$tree" drop "$@")" -9.5

generated=$tree/fall.tlgen/fall_tl.c
before=$(stat -c %.Y "$generated")
cmake --build "$tree" >/dev/null
expect "time of the generated file after a build without a change" "$(stat -c %.Y "$generated")" "$before"

sed -i 's/9\.5/1.25/' "$tree.copy/gravity.h"
cmake --build "$tree" >/dev/null
expect "after the change" "$("$tree/drop")" -1.25
if [ -e "$tree/fall_selftest" ]; then "$tree/fall_selftest" --point "q=1 qd=2" || exit 1; fi
