#!/usr/bin/env bash
# An export is written whole or not at all, takes the place of an earlier one, and leaves alone what somebody else has written.
#   refusals.sh TLGEN FOLDER-OF-MODELS
set -euo pipefail
tlgen=$1 models=$2
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
cd "$work"
cart=("$models/cart_pole.c" --lagrangian cart_pole_lagrangian --force cart_pole_force --dof 2)
fail() { echo "$*"; exit 1; }
state() { find . -type f -exec cksum {} + | sort; }
refused() { # TEXT ARGUMENT..: tlgen fails with the text, and nothing is changed
  local text=$1 before
  shift
  before=$(state)
  ! "$tlgen" "$@" 2>said || fail "not refused: $*"
  grep -qF -- "$text" said || { cat said; fail "does not say '$text'"; }
  rm said
  [ "$(state)" = "$before" ] || fail "something was changed by: $*"
}

refused 'No such file' "${cart[@]}" --export missing/folder
refused '--export writes a folder of its own' "${cart[@]}" --export out -o out.c
refused '--export writes a folder of its own' "${cart[@]}" --export out --lanes
refused '--real belongs to --export' "${cart[@]}" --real float
refused "'half' is no type" "${cart[@]}" --export out --real half
refused 'the example program has this name too' "${cart[@]}" --export out --model example
refused 'no motion functions' "${cart[@]}" --export out --need none
[ ! -e out ] || fail "a refused export leaves a folder"
touch file
refused 'is no folder' "${cart[@]}" --export file

mkdir mine && echo 'int mine;' >mine/main.c
refused 'main.c is not from an export' "${cart[@]}" --export mine
rm mine/main.c && echo 'int other;' >mine/other.c
"$tlgen" "${cart[@]}" --export mine
[ -f mine/MANIFEST ] && [ -f mine/other.c ] || fail "a file beside an export was lost"

"$tlgen" "${cart[@]}" --export out
echo 'footprint measured' >>out/MANIFEST
before=$(state)
"$tlgen" "${cart[@]}" --export out # again, over a manifest that was filled in
echo '/* mine */' >>out/main.c
refused 'main.c was changed since' "${cart[@]}" --export out --real float
[ "$before" ]

# An export of something else takes away what only the earlier one needed.
"$tlgen" "$models/snakeboard.c" --lagrangian snakeboard_lagrangian --holonomic snakeboard_drives:3 --nonholonomic snakeboard_slips:2 --dof 6 --model cart_pole --export other >said 2>&1 ||
  { cat said; fail "no export with constraints"; }
rm said
[ -f other/src/factor.c ] || fail "a model with constraints needs the solver"
"$tlgen" "${cart[@]}" --export other
[ ! -e other/src/factor.c ] || fail "a file of the earlier export was left"

if [ "$(id -u)" -ne 0 ]; then
  mkdir locked && chmod a-w locked
  refused 'Permission denied' "${cart[@]}" --export locked/out
fi
(ulimit -f 4 && refused 'cannot write' "${cart[@]}" --export small) || exit 1
[ ! -e small ] || fail "an export that could not be written leaves a folder"
