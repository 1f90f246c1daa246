#!/usr/bin/env bash
# An export compiles with the line in its MANIFEST, without a warning, in both number types, and its float run agrees with its double
# run; it has every file that it needs and none that it does not: without any one of them it does not build, and of each source something
# is left in a program without what nothing reaches from main.
#   contents.sh TLGEN COMPILER SOURCE ARGUMENT..
set -euo pipefail
tlgen=$1 compiler=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
strict=(-Wall -Wextra -Wconversion -Wno-sign-conversion -Wdouble-promotion -Wfloat-conversion -Wvla -Wpedantic -Wundef -Wcast-align -Wstrict-prototypes -Wmissing-prototypes -Werror)

for real in double float; do
  "$tlgen" "$@" --export $real --real $real
  compile=$(sed -n 's/^compile: //p' $real/MANIFEST)
  [[ $compile = "cc "* ]] || { echo "MANIFEST names no compilation"; exit 1; }
  (cd $real && eval "$compiler ${strict[*]} ${compile#cc }" && ./example >numbers && rm example)
done
paste double/numbers float/numbers | awk '
  # one line of each: words, then numbers; float has 24 bits, and 1000 steps and a linearisation may lose some of them
  { half = NF / 2; for (i = 1; i <= half; i++) { a = $i; b = $(i + half); if (a + 0 == 0 && a !~ /^-?0/) continue
      d = a - b; if (d < 0) d = -d; s = a < 0 ? -a : a; if (d > 2e-3 * (s > 1 ? s : 1)) { print "line " NR ": " a " in double, " b " in float"; bad = 1 } } }
  END { exit bad || NR == 0 }'

cd float
objects=$work/objects
mkdir "$objects"
sources=(*.c)
[ ! -d src ] || sources+=(src/*.c)
for source in "${sources[@]}"; do
  "$compiler" -std=c11 -O0 -DNDEBUG -ffunction-sections -fdata-sections -I. -Iinclude -c "$source" -o "$objects/$(basename "$source" .c).o"
done
link() { "$compiler" "$@" -lm -o "$work/linked" 2>/dev/null; }
link "$objects"/*.o || { echo "the objects do not link"; exit 1; }
failed=0
for object in "$objects"/*.o; do
  mv "$object" "$work/away"
  ! link "$objects"/*.o || { echo "$(basename "$object" .o).c is not needed"; failed=1; }
  mv "$work/away" "$object"
done
"$compiler" "$objects"/*.o -Wl,--gc-sections -lm -o "$work/linked"
names() { nm --defined-only -g "$1" | awk '{ print $3 }' | sort; }
names "$work/linked" >"$work/reached"
for object in "$objects"/*.o; do
  names "$object" >"$work/defined"
  [ -n "$(comm -12 "$work/defined" "$work/reached")" ] || { echo "nothing of $(basename "$object" .o).c is reached from main"; failed=1; }
done
mapfile -t headers < <(find . -name '*.h')
[ ${#headers[@]} -gt 5 ]
for header in "${headers[@]}"; do
  mv "$header" "$work/away"
  builds=1
  for source in "${sources[@]}"; do
    "$compiler" -std=c11 -DNDEBUG -I. -Iinclude -fsyntax-only "$source" 2>/dev/null || { builds=0; break; }
  done
  [ $builds = 0 ] || { echo "$header is not needed"; failed=1; }
  mv "$work/away" "$header"
done
exit $failed
