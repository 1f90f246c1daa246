#!/usr/bin/env bash
# build_and_run.sh SOURCE TREE PROGRAM OPTION..: builds a project in an empty folder with cmake's options, then runs its program.
set -euo pipefail
source=$1 tree=$2 program=$3
shift 3
rm -rf "$tree"
cmake -S "$source" -B "$tree" "$@" >"$tree.log" 2>&1 || { cat "$tree.log"; exit 1; }
cmake --build "$tree" >>"$tree.log" 2>&1 || { cat "$tree.log"; exit 1; }
"$tree/$program"
