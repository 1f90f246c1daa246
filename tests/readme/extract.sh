#!/usr/bin/env bash
# extract.sh README FOLDER: writes each fenced block whose opening line names a file ("```c main.c") to that file in an empty folder.
set -euo pipefail
readme=$1 folder=$2
rm -rf "$folder"
mkdir -p "$folder"
awk -v folder="$folder" '
  /^```[a-z]+ [A-Za-z0-9_.]+$/ { file = folder "/" $2; printf "" >file; next }
  /^```$/ { file = ""; next }
  file != "" { print >file }' "$readme"
for file in CMakeLists.txt main.c output.txt; do
  [ -s "$folder/$file" ] || { echo "$readme has no block \"$file\""; exit 1; }
done
lines=$(cat "$folder"/*.c | wc -l)
echo "$lines lines of C"
[ "$lines" -le 15 ]
