#!/usr/bin/env bash
# hard_cases.sh PROGRAM NAME..: the list has these scenes; a run writes its outputs; a bound that is missed, a failure and Ctrl-C show.
. "$(dirname "$0")/expect.sh"
program=$1
shift
run 0 "$program" --list
[ "$(awk '{ print $1 }' scratch/out.txt | sort)" = "$(printf '%s\n' "$@" | sort)" ] || fail "the list has other scenes than the tests"

run 0 "$program" A01 disk --quick --out .
says scratch/out.txt '^A01 +2 +1 +1 +dp5'
[ "$(wc -l <A01.csv)" -eq 22 ] || fail "A01.csv has no row for each half second of 10 s"
awk -F, 'NR == 1 { if ($0 != "t,error,energy_error,phi,phi_dot,rank") exit 1; next } NF != 6 || $4 > 1e-13 || $6 != 1 { exit 1 }' A01.csv ||
  fail "A01.csv: another head, or a row that is off the constraint"
run 0 "$program" disk --quick --markdown
says scratch/out.txt '^\| disk \| '

# Without projection the constraint drifts; with a long step bounds are missed; with a longer one the motion leaves all bounds.
run 0 "$program" A01 --quick --drift none --out .
awk -F, 'NR > 1 && $4 > 1e-13 { seen = 1 } END { exit !seen }' A01.csv || fail "no drift without projection"
run 1 "$program" A01 --quick --step 0.1
says scratch/out.txt '^A01 .* MISSED$'
run 1 "$program" A05 --quick --step 0.01
says scratch/err.txt '^hard_cases: A05 ended at t = [0-9.e-]+ s of 1 s: '
run 1 "$program" disk --quick --out missing
says scratch/err.txt "cannot write 'missing/disk.csv'"

set -m # or the shell starts background programs with Ctrl-C ignored
timeout -s KILL 100 "$program" A01 --step 1e-6 >scratch/out.txt 2>scratch/err.txt </dev/null &
id=$!
sleep 2
kill -INT $id
wait $id
status=$?
[ $status -eq 130 ] || fail "exit status $status, not 130"
says scratch/err.txt 'A01 was stopped by the user at t = '
leaves A01.csv disk.csv
