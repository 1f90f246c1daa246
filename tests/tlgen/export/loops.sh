#!/usr/bin/env bash
# Every loop of an export that does not count to a bound known before it begins is in loops.txt, with what ends it.
#   loops.sh TLGEN FOLDER-OF-MODELS
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
tlgen=$1 models=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
"$tlgen" "$models/snakeboard.c" --lagrangian snakeboard_lagrangian --holonomic snakeboard_drives:3 --nonholonomic snakeboard_slips:2 --dof 6 \
  --export all >/dev/null 2>&1
loops_of() { (cd "$1" && grep -HnE '\bwhile \(|for \([^;]*;;|\bdo \{|\bgoto\b' src/*.[ch] include/*/*.h *_tl.c) | sed -E 's/:[0-9]+: */: /' | sort; }
loops_of all >found
grep -v '^#' "$here/loops.txt" | sed 's/  *-- .*//' | sort >kept
diff kept found || { echo "loops.txt does not say what ends each loop"; exit 1; }
echo 'static void forever(void) { while (1) { } }' >>all/src/step.c # the test sees a new one
loops_of all >more
! cmp -s found more || { echo "a new loop goes unseen"; exit 1; }
