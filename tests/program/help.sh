#!/usr/bin/env bash
# help.sh PROGRAM CMAKELISTS: eom and each of its commands explain themselves, every option with what it takes, in lines that fit a terminal.
. "$(dirname "$0")/../examples/expect.sh"
program=$1
run 0 "$program" --help
version=$(sed -n 's/^project(.* VERSION \([0-9.]*\) .*/\1/p' "$2")
[ -n "$version" ] || fail "no version in $2"
says scratch/out.txt 'eom --version'
run 0 "$program" --version
says scratch/out.txt "^eom $version "
run 0 "$program" --help
commands=$(awk '/^Commands/ { on = 1; next } /^$/ { on = 0 } on { print $1 }' scratch/out.txt)
[ "$(wc -w <<<"$commands")" -ge 3 ] || fail "only these commands: $commands"
for command in '' $commands; do
  run 0 "$program" $command --help
  [ -s scratch/err.txt ] && fail "--help writes to standard error"
  says scratch/out.txt '^Usage: eom '
  says scratch/out.txt '^Exit status: 0 done'
  awk 'length > 120 { exit 1 }' scratch/out.txt || fail "a line of the help of '$command' is wider than 120 columns"
  cp scratch/out.txt scratch/help.txt
  run 0 "$program" $command -h
  cmp scratch/out.txt scratch/help.txt || fail "-h and --help differ"
  [ -n "$command" ] || continue
  says scratch/help.txt "^  eom $command [a-z_]+\.so"
  options=$(grep -oE '^  --[a-z0-9-]+ [A-Z]' scratch/help.txt | awk '{ print $1 }')
  [ "$(wc -w <<<"$options")" -ge 4 ] || fail "only these options of $command: $options"
  for option in $options; do
    run 2 "$program" $command model.so "$option"
    says scratch/err.txt "^eom: $option needs a value"
    says scratch/err.txt "'eom $command --help'"
  done
done
