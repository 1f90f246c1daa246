#!/usr/bin/env bash
# exponents.sh PROGRAM SCHEME REFERENCE: the finite-time exponents at t = 1 and 5 s agree with independently computed ones to 1e-9.
# REFERENCE has lines N t lambda_1..lambda_2N and more that is not used here.
. "$(dirname "$0")/expect.sh"
program=$1 scheme=$2 reference=$3
# The reference is good to 1e-13. The steps leave at most a tenth of the tolerance: the continuous schemes follow Q itself, which turns
# fast at N = 4, and need shorter ones. What Q loses in the printed scheme grows with time, so that one is compared at 1 s only.
tolerance=1e-9
case $scheme in
  discrete) step=0.001 last=5 sizes="1 2 4 6" ;;
  continuous) step=0.0002 last=5 sizes="1 2" ;;
  paper) step=0.0002 last=1 sizes="1 2 4" ;;
esac
for links in $sizes; do
  run 0 "$program" --links $links --scheme "$scheme" --step $step --t-end $last --every 1 --csv run.csv
  [ "$(head -1 run.csv)" = "t$(for name in lambda mean half_width; do printf ",${name}_%d" $(seq $((2 * links))); done),energy_error,orthogonality_error" ] || fail "header: $(head -1 run.csv)"
  awk -v N=$links -v last=$last -v tolerance=$tolerance '
    FNR == NR { if ($1 == N && $2 <= last) for (i = 1; i <= 2 * N; i++) { wanted[$2 + 0, i] = $(i + 2); count++ }; next }
    FNR > 1 {
      for (i = 1; i <= 2 * N; i++) {
        if (!(($1 + 0, i) in wanted)) continue
        w = wanted[$1 + 0, i]; d = $(i + 1) - w; if (d < 0) d = -d
        if (!(d <= tolerance)) { printf "N=%d t=%s lambda_%d = %s, wanted %s, difference %g\n", N, $1, i, $(i + 1), w, d; bad = 1 }
        if (d > worst) worst = d
        seen++
      }
    }
    END { printf "N=%d: %d of %d values, largest difference %.1e\n", N, seen, count, worst; exit bad || seen != count || seen == 0 }
  ' <(grep -v '^#' "$reference") <(tr , ' ' <run.csv) || fail "N=$links, scheme $scheme"
done
