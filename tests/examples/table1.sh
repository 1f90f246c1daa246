#!/usr/bin/env bash
# table1.sh PROGRAM: the table for N = 1 and 2 over a short time: its files, and what must hold of its numbers at any length.
. "$(dirname "$0")/expect.sh"
run 0 "$1" --table1 --links 2 --t-end 20 --figures out --csv table.csv --plot three.svg
[ "$(ls out | tr '\n' ' ')" = "N1.csv N1_as_printed.csv N2.csv N2_as_printed.csv fig3.svg fig4.svg fig5.svg " ] || fail "the folder holds $(ls out)"
cmp three.svg out/fig3.svg || fail "--plot and --figures draw different figures"
awk -F, '
  NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
  { printed[$1] = $column["table1"]; energy[$1] = $column["energy_error"]; end[$1] = $column["as_printed_end"]; rows++ }
  END {
    if (rows != 2) { print "rows: " rows; exit 1 }
    if (printed[1] != 3e-5 || printed[2] != 0.1) { print "not the table of the paper"; exit 1 }
    if (!(energy[1] <= 1e-6 && energy[2] <= 1e-6)) { print "energy error above 1e-6 J"; exit 1 }
    if (!(end[2] > 0 && end[2] < 1)) { print "N=2 as printed ended at " end[2] " s, wanted an overflow in the first second"; exit 1 }
  }' table.csv || fail "table.csv: $(cat table.csv)"
says scratch/out.txt '^ 2 +0\.1 '
leaves out table.csv three.svg
