#!/usr/bin/env bash
# Generated code compiles without a warning with gcc and clang, unoptimised, optimised and with clang's sanitizers for undefined
# behaviour (which stop the program), and computes the same numbers each time. In single precision it promotes no number to double. Its
# header is C++ too.
#   compilers.sh FILE_tl.c INCLUDE.. [-- OBJECT OR LIBRARY..]    with objects: links a check of a model, and runs it at two points
set -euo pipefail
file=$1
shift
includes=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do includes+=(-I"$1"); shift; done
[ $# -gt 0 ] && shift

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tried=0
for compiler in gcc clang-19; do
  command -v $compiler >/dev/null || { echo "no $compiler here"; continue; }
  $compiler -std=c11 -DTL_REAL=TL_FLOAT -Wall -Wextra -Wdouble-promotion -Wfloat-conversion -Werror "${includes[@]}" -fsyntax-only "$file"
  cxx=${compiler/gcc/g++} cxx=${cxx/clang/clang++}
  $cxx -x c++ -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Werror "${includes[@]}" -fsyntax-only -include "${file%.c}.h" /dev/null
  levels=(-O0 -O2)
  [ $compiler = gcc ] || levels+=("-O1 -fsanitize=undefined,float-divide-by-zero,float-cast-overflow,implicit-conversion -fsanitize-trap=all")
  for level in "${levels[@]}"; do
    echo "$compiler $level"
    $compiler -std=c11 $level -Wall -Wextra -Wconversion -Werror "${includes[@]}" -c "$file" -o "$work/model.o"
    tried=$((tried + 1))
    [ $# -gt 0 ] || continue
    gcc "$work/model.o" "$@" -o "$work/check"
    "$work/check" 2 >"$work/said" 2>&1 || { cat "$work/said"; exit 1; }
  done
done
[ $tried -gt 0 ]
