#!/usr/bin/env bash
# No file names a folder of the machine that it was written on: the project builds anywhere.
set -euo pipefail
git rev-parse --is-inside-work-tree >/dev/null 2>&1 || { echo "not a git checkout: skipped"; exit 77; }
# Absolute paths, that is after the beginning of a line, a space, a quote or the like, but for those that every system has.
anywhere='usr|dev|etc|proc|opt|bin|lib'
if git grep -nIP "(^|[^]A-Za-z0-9_.}<)/*-])/(?!($anywhere)/)[A-Za-z][A-Za-z0-9_]*/[A-Za-z0-9_]" -- .; then
  echo "these lines hold absolute paths of one machine"
  exit 1
fi
