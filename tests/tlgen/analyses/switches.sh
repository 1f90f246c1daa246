#!/usr/bin/env bash
# Each analysis that 'tlgen --help' names changes the functions of a model in one form or the other when it is switched off.
#   switches.sh TLGEN MODELS MECHANICS    folders of sources
set -euo pipefail
tlgen=$1 models=$2 mechanics=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

print() { # OUTPUT SOURCE ARGUMENT..
  local out=$1 source=$2
  shift 2
  "$tlgen" "$source" --model model --need all -o "$work/model_tl.c" "$@" 2> "$work/notes" || { cat "$work/notes"; exit 1; }
  mv "$work/model_tl.c" "$out"
}

each() { # FORM OUTPUT ARGUMENT..: of every model
  local form=$1 out=$2
  shift 2
  print "$out.pendulum" "$models/pendulum.c" --lagrangian pendulum_lagrangian --dof n --size n=6 --form "$form" "$@"
  print "$out.chain" "$mechanics/fput.c" --lagrangian fput_lagrangian --arg p=chain --dof nr_masses --size nr_masses=5 --form "$form" "$@"
  print "$out.furuta" "$mechanics/furuta.c" --lagrangian furuta_lagrangian --dof 2 --form "$form" "$@"
}

analyses=$("$tlgen" --help | sed -n '/--without/,/^Output/p' | sed -n 's/^ \{25\}\([a-z-]*\) .*/\1/p')
for form in registers rows; do each "$form" "$work/with.$form"; done
status=0
for analysis in $analyses; do
  changed=0
  for form in registers rows; do
    each "$form" "$work/without.$form" --without "$analysis"
    for file in "$work/with.$form".*; do cmp -s "$file" "${file/with./without.}" || changed=1; done
  done
  [ $changed = 1 ] || { echo "--without $analysis changes nothing"; status=1; }
done
[ "$(wc -w <<< "$analyses")" -ge 5 ] || { echo "tlgen --help names no analyses"; status=1; }
exit $status
