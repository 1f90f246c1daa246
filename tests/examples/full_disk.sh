#!/usr/bin/env bash
# full_disk.sh PROGRAM OPTION..: a full disk, a place that cannot be written to and a lost reader are reported with status 1, and no
# partial file stays.
. "$(dirname "$0")/expect.sh"
full_device scratch/full
run 1 "$@" --csv scratch/full
says scratch/err.txt "cannot write 'scratch/full': No space left on device"
[ -c scratch/full ] || fail "the device has been replaced by a file"
run 1 "$@" --csv missing/run.csv
says scratch/err.txt "cannot write 'missing/run.csv': No such file or directory"
run 1 "$@" --csv .
says scratch/err.txt "cannot write '.': Is a directory"
leaves

# A file that may not grow beyond a kilobyte stands for a disk that fills up on the way; a file that was there stays as it was.
echo before >run.csv
(
  trap '' XFSZ
  ulimit -f 1
  "$@" --csv run.csv >/dev/null 2>scratch/small.txt
)
[ $? -eq 1 ] || fail "no failure though the file could not grow"
says scratch/small.txt "cannot write 'run.csv': File too large"
[ "$(cat run.csv)" = before ] || fail "the file that was there has changed"
leaves run.csv

"$@" >scratch/full 2>scratch/err.txt
[ $? -eq 1 ] || fail "no failure though standard output is full"
says scratch/err.txt 'cannot write to standard output'

# A device or pipe is written to as it is.
run 0 "$@" --csv /dev/stdout
says scratch/out.txt '^t,'
