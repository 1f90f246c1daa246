#!/usr/bin/env bash
# Every id that tlgen can print is expected by a source here.
#   complete.sh TLGEN FOLDER
set -euo pipefail
missing=0
for id in $("$1" --explain | sed 's/:.*//'); do
  [ "$id" = no-file ] && continue # usage.sh
  grep -rqE "/\* (expect|warns|notes)[a-z ]*: ([a-z-]+ )*$id( |$)" "$2"/*.c "$2"/parts/*.c || { echo "no source expects $id"; missing=1; }
done
exit $missing
