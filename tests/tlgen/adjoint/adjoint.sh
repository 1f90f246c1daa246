#!/usr/bin/env bash
# One model: for each line of VARIANTS, a file here, tlgen prints its motion functions with these options, the same in every run, the
# compiler takes them without a warning, nor one of a promotion to double in single precision, and check.c compares them with the model's jets. One form may be unsuitable, the automatic
# choice may not. For a model of unsuitable.txt tlgen must say why there are none.
# Under sanitizers a model whose first form is long is done with that: other models show them the other form.
#   adjoint.sh VARIANTS NAME TLGEN REFERENCE|random COMPILER|each TLGEN-ARGUMENT.. -- COMPILER-ARGUMENT.. -- OBJECT OR LIBRARY..
# COMPILER: with its options, in the place of those of VARIANTS; the automatic choice of form, which is one of the others, and the second
# run are left out.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
variants=$1 name=$2 tlgen=$3 reference=${4#random} only=${5#each}
shift 5
long=400000 # bytes of C: optimising compilers take minutes for more
model=() includes=()
while [ "$1" != -- ]; do model+=("$1"); shift; done
shift
while [ "$1" != -- ]; do includes+=("$1"); shift; done
shift

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
fail() { echo "$name, $variant: $*"; failed=1; }

print() { "$tlgen" "${model[@]}" --need all "$@" -o "$work/${name}_tl.c" -- "${includes[@]}" >"$work/said" 2>&1; }

variant=
reason=$(sed -n "s/^$name: //p" "$here/unsuitable.txt")
if [ -n "$reason" ]; then
  print && grep -F "$reason" "$work/said" | grep -q '\[adjoint-unsuitable\]' || { cat "$work/said"; fail "is it still unsuitable, because '$reason'?"; }
  exit $failed
fi

tried=0
while IFS='|' read -r compiler variant; do
  case $compiler in '' | '#'*) continue ;; esac
  [ "$only" ] && [[ $variant = *auto* ]] && continue
  read -ra compile <<<"${only:-$compiler}"
  read -ra options <<<"$variant"
  command -v "${compile[0]}" >/dev/null || { echo "no ${compile[0]} here"; continue; }
  tried=$((tried + 1))
  print "${options[@]}" || { cat "$work/said"; fail tlgen; continue; }
  if [ ! "$only" ] && [ "$variants" = variants.txt ]; then
    mv "$work/${name}_tl.c" "$work/first"
    print "${options[@]}" && cmp -s "$work/first" "$work/${name}_tl.c" || fail "tlgen prints other code in another run"
  fi
  if [[ $variant != *auto* ]] && grep -q '\[adjoint-unsuitable\]' "$work/said"; then # in this form alone
    sed -n 's/.*note: \(.*\): No motion.*/no such form: \1/p' "$work/said"
    continue
  fi
  size=$(wc -c <"$work/${name}_tl.c")
  [ "$size" -gt $long ] && compile+=(-O0)
  "${compile[@]}" -std=c11 -Wall -Wextra -Wconversion -Werror "${includes[@]}" -c "$work/${name}_tl.c" -o "$work/model.o" || { fail compiler; continue; }
  gcc -std=c11 -DTL_REAL=TL_FLOAT -Wall -Wextra -Wdouble-promotion -Wfloat-conversion -Werror "${includes[@]}" -fsyntax-only "$work/${name}_tl.c" ||
    fail "single precision"
  gcc "$work/model.o" "$@" -o "$work/check" || { fail linker; continue; }
  "$work/check" ${reference:+"$reference"} >"$work/numbers"
  case $? in
    0)
      echo "${compile[*]} | $variant: $(cat "$work/numbers")"
      [[ $only = *-fsanitize* ]] && [ "$size" -gt $long ] && break
      ;;
    3) grep -q '\[adjoint-large\]' "$work/said" || { cat "$work/said"; fail "no functions"; } ;; # all of them too long
    *) fail check ;;
  esac
done <"$here/$variants"
[ $tried -gt 0 ] && exit $failed
