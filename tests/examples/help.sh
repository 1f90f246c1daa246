#!/usr/bin/env bash
# help.sh PROGRAM..: --help, or -h, explains every option that the program knows, with examples that run.
. "$(dirname "$0")/expect.sh"
for program in "$@"; do
  run 0 "$program" --help
  [ -s scratch/err.txt ] && fail "--help writes to standard error"
  says scratch/out.txt '^Usage: '
  says scratch/out.txt '^Examples'
  awk 'length > 120 { exit 1 }' scratch/out.txt || fail "a line of the help is wider than 120 columns"
  cp scratch/out.txt scratch/help.txt
  run 0 "$program" -h
  cmp scratch/out.txt scratch/help.txt || fail "-h and --help differ"
  # No option is known and not explained: those that the source lists are those of the help.
  while read -r option; do
    run 2 "$program" "$option" # each needs a value, or (a flag) is followed by one that does
    says scratch/err.txt "^[a-z_]+: $option"
  done < <(grep -oE '^  --[a-z0-9-]+ [A-Zaf-z|]+' scratch/help.txt | awk '{ print $1 }')
done
