#!/usr/bin/env bash
# libtaylor compiled by itself: no undefined symbol beyond libm and the four memory functions that compilers insert, no writable data,
# and no memory of its own. Usage: symbols.sh COMPILER LIBTAYLOR-FOLDER
set -euo pipefail
compiler=$1 folder=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for source in "$folder"/src/*.c; do
  "$compiler" -std=c11 -O2 -DNDEBUG -I"$folder/include" -c "$source" -o "$work/$(basename "$source" .c).o"
done
ar rc "$work/libtaylor.a" "$work"/*.o

nm --defined-only "$work/libtaylor.a" | awk 'NF == 3 { print $3 }' | sort -u >"$work/defined"
nm --undefined-only "$work/libtaylor.a" | awk '$1 == "U" { print $2 }' | sort -u >"$work/undefined"
libm=$("$compiler" -print-file-name=libm.so.6)
nm -D --defined-only "$libm" | awk '{ sub(/@.*/, "", $3); print $3 }' | sort -u >"$work/libm"
printf '%s\n' memcpy memmove memset memcmp | sort -u >"$work/compiler"

foreign=$(comm -23 "$work/undefined" <(sort -u "$work/defined" "$work/libm" "$work/compiler"))
data=$(nm "$work/libtaylor.a" | awk '$2 ~ /^[bBdDC]$/ { print $3 }')
[ -z "$foreign" ] || echo "symbols from elsewhere: $foreign"
[ -z "$data" ] || echo "writable data: $data"
[ -s "$work/undefined" ] && [ -z "$foreign" ] && [ -z "$data" ]
