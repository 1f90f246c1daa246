#!/usr/bin/env bash
# hard_cases.sh PROGRAM NAME..: the list has these scenes, and so has docs/hard-cases.md; a run writes its outputs; a bound that is missed,
# a failure and Ctrl-C show.
page=$(realpath "$(dirname "$0")/../../docs/hard-cases.md")
. "$(dirname "$0")/expect.sh"
program=$1
shift
run 0 "$program" --list
[ "$(awk '{ print $1 }' scratch/out.txt | sort)" = "$(printf '%s\n' "$@" | sort)" ] || fail "the list has other scenes than the tests"
for name in "$@"; do says "$page" "^\\| $name \\|"; done

run 0 "$program" A01 disk --quick --out .
says scratch/out.txt '^A01 +2 +1 +1 +dop853 +1e-14'
[ "$(wc -l <A01.csv)" -eq 22 ] || fail "A01.csv has no row for each half second of 10 s"
awk -F, 'NR == 1 { if ($0 != "t,error,energy_error,phi,phi_dot,rank") exit 1; next } NF != 6 || $4 > 1e-13 || $6 != 1 { exit 1 }' A01.csv ||
  fail "A01.csv: another head, or a row that is off the constraint"
run 0 "$program" disk --quick --markdown
says scratch/out.txt '^\| disk \| '

# Over the whole time the constraint drifts without projection, far less with Baumgarte's terms, whose rate matters.
drift() {
  "$program" A01 --method dp5 --step 0.01 --out . "$@" >scratch/out.txt 2>scratch/err.txt # its bounds are missed or not
  awk -F, 'NR > 1 && $4 > most { most = $4 } END { print most }' A01.csv
}
read -r none slow fast kept <<<"$(drift --drift none) $(drift --drift baumgarte --rate 1) $(drift --drift baumgarte) $(drift)"
echo "largest |phi| without projection $none, with Baumgarte's terms at 1/s $slow, at 10/s $fast, with projection $kept"
awk "BEGIN { exit !($none > 1e-5 && $slow < 1e-4 * $none && $fast < 1e-4 * $none && $fast != $slow && $kept <= 1e-12) }" || fail "that is not how they compare"

# With a long step bounds are missed; with a longer one the motion leaves all bounds.
run 1 "$program" A01 --quick --method rk4 --step 0.1
says scratch/out.txt '^A01 .* MISSED$'
run 1 "$program" A05 --quick --method dp5 --step 0.01
says scratch/err.txt '^hard_cases: A05 ended at t = [0-9.e-]+ s of 1 s: '
run 1 "$program" disk --quick --out missing
says scratch/err.txt "cannot write 'missing/disk.csv'"

# Figures of all problems that have one, whole.
mkdir figures
run 0 "$program" --figures figures --quick
[ "$(ls figures | tr '\n' ' ')" = "drift.svg speed_A01.svg speed_A02_2.svg speed_A03.svg speed_A04.svg speed_A05.svg " ] || fail "figures: $(ls figures)"
for f in figures/*.svg; do tail -c 20 "$f" | grep -q '</svg>' || fail "$f has no end"; done
for f in figures/speed_*.svg; do
  for i in 1 2 3 4 5 6; do grep -q "gnuplot_plot_$i\"" "$f" || fail "$f: curve $i is missing"; done
done
rm -r figures
run 1 "$program" --figures missing --quick
says scratch/err.txt "cannot write 'missing/drift.svg'"

set -m # or the shell starts background programs with Ctrl-C ignored
timeout -s KILL 100 "$program" A01 --step 1e-5 >scratch/out.txt 2>scratch/err.txt </dev/null &
id=$!
sleep 2
kill -INT $id
wait $id
status=$?
[ $status -eq 130 ] || fail "exit status $status, not 130"
says scratch/err.txt 'A01 was stopped by the user at t = '
leaves A01.csv disk.csv
