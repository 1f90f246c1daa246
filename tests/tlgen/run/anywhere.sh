#!/usr/bin/env bash
# Generated files and messages do not depend on where a source lies, by what path it is named, or the folder tlgen runs in.
#   anywhere.sh TLGEN MODELS
set -uo pipefail
tlgen=$1 models=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir -p first "second place/x y/#1" elsewhere
echo 'double L(const double *q, const double *qd) { static double n; n += q[0]; return qd[0] * (int)q[0]; }' >first/bad.c
cp "$models"/*.[ch] first
cp first/* "second place/x y/#1"
options() {
  local source=$1 out=$2
  for name in pendulum double_pendulum knife_edge; do
    echo "'$source/$name.c' --lagrangian ${name}_lagrangian --dof 3 -o '$out/${name}_tl.c' -MD"
  done
}
failed=0
compared=0

# same FOLDER: the files there are those in the folder "one".
same() {
  for file in one/*.c one/*.h; do
    cmp "$file" "$1/$(basename "$file")" || failed=1
    compared=$((compared + 1))
  done
}
mkdir one two three
options first one >list && "$tlgen" --models list || failed=1
options "$work/second place/x y/#1" "$work/two" >list && (cd elsewhere && LC_ALL=C TZ=Asia/Tokyo "$tlgen" --models ../list) || failed=1
options . ../../../three >list && (cd "second place/x y/#1" && "$tlgen" --models ../../../list) || failed=1
same two
same three
[ $compared = 12 ] || { echo "$compared files compared"; failed=1; }
if grep -l "$work" two/*.c two/*.h; then echo "these files name a folder"; failed=1; fi

# Make finds every file of the rule, whatever its name.
(cd elsewhere && sed 's|^/.*/pendulum_tl.c:|made:|; 1s|^[^:]*:|made:|' ../two/pendulum_tl.c.d >rule.mk && echo '	touch $@' >>rule.mk && make -s -f rule.mk made) ||
  { echo "make cannot read the rule"; cat elsewhere/rule.mk; failed=1; }

# messages COMMAND..: what it says, without folders.
messages() { "$@" 2>&1 | sed -E 's|^.*/bad\.c:|bad.c:|; s|^bad\.c:|bad.c:|'; }
bad=(--lagrangian L --dof 1)
one=$(messages "$tlgen" first/bad.c "${bad[@]}")
[ -n "$one" ] && [ "$one" = "$(cd elsewhere && messages "$tlgen" "$work/second place/x y/#1/bad.c" "${bad[@]}")" ] || { echo "messages differ"; failed=1; }
exit $failed
