#!/usr/bin/env bash
# same_file.sh PROGRAM: two outputs that are one file are refused with status 2 before the run, by whatever names.
. "$(dirname "$0")/expect.sh"
refused() {
  run 2 timeout -s KILL 20 "$@"
  says scratch/err.txt 'the same file'
  says scratch/err.txt '--help'
}
refused "$1" --t-end 1e6 --csv a.svg --plot a.svg
refused "$1" --t-end 1e6 --csv a.svg --plot ./a.svg
refused "$1" --t-end 1e6 --csv "$PWD/a.svg" --plot a.svg --table1
refused "$1" --t-end 1e6 --figures out --csv out/N2.csv
refused "$1" --t-end 1e6 --figures out/ --plot out/fig4.svg
leaves
echo before >a.svg
ln -s a.svg b.svg
refused "$1" --t-end 1e6 --csv a.svg --plot b.svg
[ "$(cat a.svg)" = before ] || fail "the file that was there has changed"
mkdir out
refused "$1" --t-end 1e6 --figures out --plot "$PWD/out/fig3.svg"
# Beside each other is no conflict.
run 0 "$1" --t-end 2 --step 0.01 --csv a.csv --plot out/mine.svg --figures out
leaves a.csv a.svg b.svg out
