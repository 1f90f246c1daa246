#!/usr/bin/env bash
# bad_input.sh PROGRAM TABLE: each line of the table is arguments, then " => ", then what the message must say. The program says so in one
# message that points to --help, prints nothing else, leaves no file and exits with status 2.
. "$(dirname "$0")/expect.sh"
program=$1 cases=0
while IFS= read -r line; do
  case $line in '#'* | '') continue ;; esac
  arguments=${line%% => *}
  wanted=${line#* => }
  eval "run 2 \"\$program\" $arguments"
  says scratch/err.txt "$wanted"
  says scratch/err.txt '--help'
  [ -s scratch/out.txt ] && fail "output beside the message for: $arguments"
  leaves
  cases=$((cases + 1))
done <"$2"
[ $cases -gt 10 ] || fail "only $cases cases were read"
echo "$cases cases"
