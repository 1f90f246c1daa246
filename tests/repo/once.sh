#!/usr/bin/env bash
# once.sh BUILD: each label that a preset of CMakePresets.json leaves out is one that tests of this build have.
set -euo pipefail
labels=$(sed -n 's/.*"exclude": {"label": "^\([^"]*\)$"}.*/\1/p' CMakePresets.json | tr -d '()' | tr '|' '\n' | sort -u)
[ -n "$labels" ] || { echo "no preset leaves anything out"; exit 1; }
for label in $labels; do
  count=$(ctest --test-dir "$1" -N -L "^$label\$" | sed -n 's/^Total Tests: //p')
  echo "$label: $count tests"
  [ "$count" -gt 0 ]
done
