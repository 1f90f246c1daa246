#!/usr/bin/env bash
# tlgen answers a source with exactly the messages that it announces; where one is an error, it leaves no file behind.
#   refuse.sh TLGEN SOURCE
# The source says  /* tlgen: ARGUMENTS */  once (default: --lagrangian L --dof 1), and  /* expect: ID .. */  on each line at fault;
# In the arguments HERE: is the source's folder; of further sources the lines count too.
# /* expect without a line: ID .. */ is for faults of the command line, /* warns: ID .. */ for warnings, and
# /* notes: ID .. */ for notes. A source that announces nothing is accepted without a word.
set -euo pipefail
tlgen=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

arguments=$(sed -n 's|^.*/\* tlgen: \([^*]*\) \*/.*$|\1|p' "$source")
read -ra arguments <<<"${arguments:---lagrangian L --dof 1}"
arguments=("${arguments[@]//HERE:/$(dirname "$source")/}")
sources=("$source")
for argument in "${arguments[@]}"; do [[ $argument != *.c ]] || sources+=("$argument"); done

{
  sed -n 's|^.*/\* expect without a line: \(.*\) \*/.*$|0 \1|p' "$source"
  sed -sn '/\/\* expect: /{=;p}' "${sources[@]}" | sed 'N;s|^\([0-9]*\)\n.*/\* expect: \(.*\) \*/.*$|\1 \2|'
  sed -sn '/\/\* \(warns\|notes\): /{=;p}' "${sources[@]}" | sed 'N;s#^\([0-9]*\)\n.*/\* \(warns\|notes\): \(.*\) \*/.*$#\1 \3#'
} | while read -r line ids; do for id in $ids; do echo "$line $id"; done; done | sort -u >"$work/expected"

cd "$work"
status=0
"$tlgen" "$source" "${arguments[@]}" --model m -o out.c -MD -- -std=c11 2>messages >printed || status=$?

# FILE:LINE:COLUMN: error: TEXT [ID], or FILE: error: TEXT [ID]
sed -n 's|^[^ ]*\.c: error: .* \[\([a-z-]*\)\]$|0 \1|p; s|^tlgen: error: .* \[\([a-z-]*\)\]$|0 \1|p; s#^[^ ]*:\([0-9]*\):[0-9]*: \(error\|warning\|note\): .* \[\([a-z-]*\)\]$#\1 \3#p' \
  messages | sort -u >found

failed=0
wanted=0
grep -q '/\* expect' "$source" && wanted=1
[ "$status" = $wanted ] || { echo "exit status $status, not $wanted"; failed=1; }
diff -u "$work/expected" found || { echo "- expected, + found (line, id)"; failed=1; }
[ "$(grep -c '^  instead: ' messages)" -ge "$(wc -l <found)" ] || { echo "a message without a way out"; failed=1; }
left=$(ls | { grep -vE '^(expected|found|messages|printed)$' || true; } | paste -sd ' ')
written=
[ $wanted = 1 ] || written="out.c out.c.d out.h"
[ "$left" = "$written" ] || { echo "left behind: $left"; failed=1; }
[ ! -s printed ] || { echo "something on stdout"; failed=1; }
[ $failed = 0 ] || cat messages
exit $failed
