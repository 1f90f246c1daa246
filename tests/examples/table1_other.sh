#!/usr/bin/env bash
# table1_other.sh PROGRAM: from another start, or over a time shorter than the paper's, --table1 says so and concludes no more than that.
. "$(dirname "$0")/expect.sh"
run 0 "$1" --table1 --links 1 --t-end 20 --theta0 3 --csv table.csv
says scratch/out.txt "^ Table 1 starts from theta_1\(0\) = 75 deg, these runs from 3 deg: .*left out\.$"
grep -E 'Table 1' scratch/out.txt | grep -Eq 'inside|outside|Table 1  |Table 1 is|given Table 1|values of Table 1' && fail "another start is held against Table 1"
grep -q '3e-05' scratch/out.txt && fail "the paper's value stands beside another start"
[ "$(tail -n +2 table.csv | cut -d, -f2)" = "" ] || fail "table.csv holds the paper's value for another start"

run 0 "$1" --table1 --links 2 --t-end 20
says scratch/out.txt '^ Table 1 is of 1000 s, these runs are of 20 s: what follows holds for 20 s\.$'
says scratch/out.txt '^ What the intervals of 1000 s would say of Table 1 is left open\.$'
grep -q 'So the values of Table 1' scratch/out.txt && fail "20 s conclude about 1000 s"

# The step is said to be chosen only where it is.
says scratch/out.txt 'steps chosen so that'
run 0 "$1" --table1 --links 1 --t-end 5 --step 0.01
says scratch/out.txt '^ Q re-orthonormalised, step 0\.01 s$'
leaves table.csv
