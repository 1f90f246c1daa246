#!/usr/bin/env bash
# examples.sh PROGRAM MODELS STARTS: every start file of the examples runs and draws its model; Andrews' mechanism reaches the digits of a
# solution in quadruple precision, with each kind of method.
. "$(dirname "$0")/../examples/expect.sh"
program=$1 models=$2 starts=$3 count=0
help=$("$program" run --help)
for start in "$starts"/*.txt; do
  name=$(basename "$start" .txt)
  run 0 "$program" watch "$models/$name.so" --start "$start" --t-end 0.1 --rate 50 --svg "$name.svg"
  [ -s scratch/err.txt ] && fail "$start says: $(cat scratch/err.txt)"
  run 0 "$program" linearise "$models/$name.so" --start "$start"
  rm "$name.svg"
  count=$((count + 1))
done
[ $count -ge 6 ] || fail "only $count start files"

for method in dop853 cvode_bdf arkode_fehlberg8; do
  grep -q "^  $method " <<<"$help" || continue # without SUNDIALS
  option=$([ $method = arkode_fehlberg8 ] && echo --no-projection)
  run 0 "$program" run "$models/andrews.so" --start "$starts/andrews.txt" --t-end 0.03 --rtol 1e-10 --atol 1e-10 --method $method $option --csv a.csv
  tail -n 1 a.csv | awk -F, '{ d = $2 - 15.81077119515371; print "beta is off by", d; exit !(d < 1e-5 && d > -1e-5) }' || fail "$method ends elsewhere"
done
