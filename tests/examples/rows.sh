#!/usr/bin/env bash
# rows.sh PROGRAM: the CSV file has a row every --every seconds and one at the end, the same bytes in every run, and --step, --theta0,
# --t-end and --every do what they say.
. "$(dirname "$0")/expect.sh"
program=$1
times() { tail -n +2 "$1" | cut -d, -f1 | tr '\n' ' '; }

run 0 "$program" --t-end 3 --csv a.csv
[ "$(times a.csv)" = "0.5 1 1.5 2 2.5 3 " ] || fail "rows at $(times a.csv)"
awk -F, 'NR > 1 && !($(NF-1) <= 1e-6 && NF == 15) { exit 1 }' a.csv || fail "energy error above 1e-6 J, or a row of another width"
run 0 "$program" --t-end 3 --csv b.csv
cmp a.csv b.csv || fail "two runs differ"

run 0 "$program" --t-end 1.25 --every 0.5 --step 0.01 --csv c.csv
[ "$(times c.csv)" = "0.5 1 1.25 " ] || fail "rows at $(times c.csv)"
run 0 "$program" --t-end 0.3 --step 0.01 --csv d.csv
[ "$(times d.csv)" = "0.3 " ] || fail "rows at $(times d.csv)"

# From the downward position at rest nothing moves: no energy error, and for one link lambda = 0 up to the swing of the tangents.
run 0 "$program" --links 1 --theta0 0 --t-end 2 --step 0.01 --csv e.csv
awk -F, 'NR > 1 && $(NF-1) > 1e-15 { exit 1 }' e.csv || fail "a pendulum at rest gains energy"
run 0 "$program" --links 1 --theta0 75 --t-end 2 --step 0.05 --csv f.csv
awk -F, 'NR > 1 && $(NF-1) > 1e-7 { seen = 1 } END { exit !seen }' f.csv || fail "a step of 0.05 s shows no energy error"

# The intervals of a row are those by its time: none in the first row, in the last what is printed at the end.
run 0 "$program" --links 1 --t-end 50 --csv g.csv
awk -F, 'NR == 2 { exit $6 != "inf" }' g.csv || fail "an interval from four marks"
interval=$(tail -n 1 g.csv | awk -F, '{ printf "lambda_1 = %.4g [+]- %.2g 1/s", $4, $6 }')
says scratch/out.txt "$interval"
leaves a.csv b.csv c.csv d.csv e.csv f.csv g.csv
