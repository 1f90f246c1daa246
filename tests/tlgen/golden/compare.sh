#!/usr/bin/env bash
# Whole files of generated code against the ones kept here, from two folders and by two paths; ACCEPT=1 rewrites the kept ones and fails.
#   compare.sh TLGEN FOLDER NAME SOURCE ARGUMENT..    FOLDER holds NAME_tl.c, NAME_tl.h and, of --report, NAME.report
set -euo pipefail
tlgen=$1 kept=$2 name=$3 source=$4
shift 4

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/absolute" "$work/other folder"
compiler=(-- -std=c11 -I"$(dirname "$source")")

(cd "$work/absolute" && "$tlgen" "$source" --model "$name" "$@" -o "${name}_tl.c" "${compiler[@]}" >"$name.report")
cp "$source" "${source%.c}.h" "$work/other folder" 2>/dev/null || cp "$source" "$work/other folder"
(cd "$work/other folder" && mkdir out && "$tlgen" "./$(basename "$source")" "$@" --model="$name" -o "out/${name}_tl.c" -- -std=c11 >"out/$name.report")

files=("${name}_tl.c" "${name}_tl.h")
[[ " $*" != *" --report"* ]] || files+=("$name.report")
status=0
for file in "${files[@]}"; do
  cmp "$work/absolute/$file" "$work/other folder/out/$file" || { echo "$file depends on the folder or the path of the source"; status=1; }
  if [ "${ACCEPT:-0}" = 1 ]; then
    cp "$work/absolute/$file" "$kept/$file"
    echo "accepted $file: look at it, then run the test again"
    status=1
  elif ! diff -u "$kept/$file" "$work/absolute/$file"; then
    echo "$file is not the one that is kept; ACCEPT=1 takes the new one"
    status=1
  fi
done
exit $status
