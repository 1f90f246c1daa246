#!/usr/bin/env bash
# No file names a folder of the machine that it was written on: the project builds anywhere.
set -euo pipefail
git rev-parse --is-inside-work-tree >/dev/null 2>&1 || { echo "not a git checkout: skipped"; exit 77; }
folders='home|root|work|farm|mnt|media|Users|tmp'
# An absolute path starts after the beginning of a line, a space or a quote; the temporary folder is named by TMPDIR only.
pattern="(^|[^]A-Za-z0-9_.}<)/-])/($folders)/[A-Za-z0-9_]"
if git grep -nIE "$pattern" -- .; then
  echo "these lines hold absolute paths of one machine"
  exit 1
fi
