#!/usr/bin/env bash
# resume.sh PROGRAM OPTION..: a Lyapunov run that is killed outright at several moments and resumed ends with the same bytes as one that
# never stopped; so does one that Ctrl-C ended.
. "$(dirname "$0")/../examples/expect.sh"
set -m # or the shell starts background programs with Ctrl-C ignored
outputs="--csv run.csv --npz run.npz"

# stop SIGNAL FILE COMMAND..: sends the signal as soon as the command has written the file anew; sets status to its exit status.
stop() {
  local signal=$1 file=$2 before process
  before=$(stat -c %i.%.Y "$file" 2>/dev/null)
  shift 2
  "$@" >scratch/out.txt 2>scratch/err.txt </dev/null &
  process=$!
  while [ "$(stat -c %i.%.Y "$file" 2>/dev/null)" = "$before" ] && kill -0 $process 2>/dev/null; do sleep 0.01; done
  kill -s "$signal" $process || fail "it ended before it was stopped: $*"
  wait $process
  status=$?
}

# Neither where a run ends nor how often it was stopped is to be seen in its bytes: those to be stopped would take for ever.
for _ in 1 2 3; do
  stop KILL run.state "$@" --t-end 1e6 --checkpoint run.state --save-every 0 --resume
  [ $status -eq 137 ] || fail "killed, it ended with status $status"
  rm -f run.state.*.part # a kill during a write leaves its temporary
done
stop INT run.state "$@" --t-end 1e6 --checkpoint run.state --save-every 0 --resume $outputs
[ $status -eq 130 ] || fail "Ctrl-C ended the run with status $status"
says scratch/err.txt 'stopped by the user at t = .*; --resume goes on from there'
stopped=$(sed -n 's/.*stopped by the user at t = \([0-9]*\).*/\1/p' scratch/err.txt)
end=$((stopped + 200))
run 0 "$@" --t-end $end --checkpoint run.state --resume $outputs
cp scratch/out.txt resumed.txt
mkdir resumed && mv run.csv run.npz resumed
run 0 "$@" --t-end $end $outputs
says scratch/out.txt '^  lambda_1 '
cmp run.csv resumed/run.csv && cmp run.npz resumed/run.npz || fail "the resumed run gave other bytes"
cmp scratch/out.txt resumed.txt || fail "the resumed run printed something else"

# What is no checkpoint of this run is refused, and stays as it is.
cp run.state kept.state
refused() {
  run 1 "$@" --t-end $end --checkpoint run.state --resume
  says scratch/err.txt "--checkpoint run.state: .*${why:-}.*with --replace in the place of --resume"
  cmp -s run.state "$wanted" || fail "the file has changed"
}
for damage in 'head -c 5000' 'tail -c 5000' "sed s/rows/rovs/" 'tr \000 \001'; do
  $damage kept.state >run.state 2>/dev/null
  cp run.state damaged.state
  wanted=damaged.state refused "$@"
done
cp kept.state run.state
wanted=kept.state
why='with --scheme = discrete, not continuous' refused "$@" --scheme continuous
why='with g = 9.81.*, not 9.80' refused "$@" --set g=9.8
why='with qd\[1\] = 0, not 0.5' refused "$@" --qd 0,0.5
why='with --t0 = 0, not 1' refused "$@" --t0 1
why='with --every = 0.2.*, not 0.25' refused "$@" --every 0.25
run 1 "$@" --checkpoint run.state --resume --t-end 100
says scratch/err.txt "--t-end 100: the run of --checkpoint run.state is at t = $end s already"

# A checkpoint is replaced on purpose only, and nothing else ever is.
run 2 "$@" --checkpoint run.state
says scratch/err.txt '--resume goes on from it, --replace begins anew'
cmp -s run.state kept.state || fail "the file has changed"
echo text >notes.txt
for option in '' --replace; do
  run 2 "$@" --checkpoint notes.txt $option
  says scratch/err.txt 'there is a file already that is no checkpoint'
done
[ "$(cat notes.txt)" = text ] || fail "the text has been replaced"
run 0 "$@" --t-end 1 --checkpoint run.state --replace
run 0 "$@" --t-end 2 --checkpoint run.state --resume
says scratch/out.txt ' from t = 0 s to 2 s,'

# Rows far apart: Ctrl-C and --save-every need not wait for one, and the row to come has the bits of a run that never stopped.
far="--every 400 --t-end 400"
run 0 "$@" $far --csv whole.csv
run 0 "$@" $far --until 1e9 --after 30 --checkpoint far.state --csv part.csv
says scratch/out.txt ' from t = 0 s to [23][0-9.]+ s,'
run 0 "$@" $far --checkpoint far.state --resume --csv run.csv
cmp run.csv whole.csv || fail "the resumed run gave other bytes"
[ "$(wc -l <run.csv) $(wc -l <part.csv)" = "2 2" ] || fail "not a row each"
stop INT far.state "$@" --every 1e8 --t-end 1e9 --checkpoint far.state --replace --save-every 0
[ $status -eq 130 ] || fail "Ctrl-C ended the run with status $status"
says scratch/err.txt 'stopped by the user at t = [0-9.]+ s; --resume goes on from there'
says scratch/out.txt '^  lambda_1 '
