#!/usr/bin/env bash
# --models: every line is a model; all their messages come in one run, all their files or none are written, a source is read once.
#   models.sh TLGEN
set -uo pipefail
tlgen=$1 here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
. "$here/expect.sh"
mkdir out "in here"
cat >"in here/springs.c" <<'END'
double one(const double *q, const double *qd) { return qd[0] * qd[0] - K * q[0] * q[0]; }
double two(const double *q, const double *qd) { return qd[0] * qd[0] + qd[1] * qd[1] - K * (q[0] - q[1]) * (q[0] - q[1]); }
double bad(const double *q, const double *qd) { static double n; n += 1; return qd[0] * q[0]; }
double worse(const double *q, const double *qd) { return qd[0] * (int)q[0]; }
END
cat >good.models <<'END'
# two models of one file
"in here/springs.c" --lagrangian one --dof 1 --model one -o out/one_tl.c -- -DK=2
'in here'/springs.c --lagrangian two \
  --dof=2 --model two -o out/two_tl.c -- "-DK=2"  # two masses
END

expect 0 "" "$tlgen" --models good.models -MD --sarif out/m.sarif
[ "$(grep -c good.models out/one_tl.c.d)" = 1 ] || { echo "the rule of one_tl.c does not name the file of models"; failed=1; }
grep -q 'in\\ here/springs.c' out/two_tl.c.d || { echo "the rule of two_tl.c does not name its source"; failed=1; }
cp out/one_tl.c out/two_tl.c .
expect_files one_tl.c one_tl.h one_tl.c.d two_tl.c two_tl.h two_tl.c.d m.sarif

# The same as by two runs.
"$tlgen" "in here/springs.c" --lagrangian one --dof 1 --model one -o out/one_tl.c -- -DK=2 || failed=1
"$tlgen" "in here/springs.c" --lagrangian two --dof 2 --model two -o out/two_tl.c -- -DK=2 || failed=1
for file in one_tl.c two_tl.c; do cmp $file out/$file || failed=1; done
rm -f out/*

# Messages of all models, each once, and no file.
cat >bad.models <<'END'
--lagrangian one --dof 1 --model one -o out/one_tl.c
--lagrangian bad --dof 1 --model bad -o out/bad_tl.c
--lagrangian worse --dof 1 --model worse -o out/worse_tl.c
--lagrangian bad --dof 2 --model bad2 -o out/bad2_tl.c
END
expect 1 "[global-state]" "$tlgen" --models bad.models "in here/springs.c" -- -DK=1
grep -q '\[active-integer\]' said || { echo "the third model's message is missing"; failed=1; }
[ "$(grep -c 'error:' said)" = "$(grep 'error:' said | sort -u | wc -l)" ] || { echo "a message twice"; cat said; failed=1; }
expect_files

# One source and one set of compiler arguments is one reading of the file, another set is another.
if command -v strace >/dev/null; then
  sed 's/=2"/=3"/' good.models >three.models
  for case in good:1 three:2; do
    ASAN_OPTIONS=detect_leaks=0 strace -f -e trace=open,openat -o trace "$tlgen" --models ${case%:*}.models
    opened=$(grep -c 'springs\.c"' trace)
    [ "$opened" = "${case#*:}" ] || { echo "${case%:*}.models: springs.c was opened $opened times"; failed=1; }
  done
  rm -f out/*
fi

echo '"in here/springs.c --dof 1' >open.models
echo '# nothing' >none.models
printf 'good.c\n\n--sarif x --dof 1\n' >sarif.models
printf 'good.c\n--dof 1 a.c --werror\n' >werror.models
printf '\n"in here/springs.c" --lagrangian one --dof 1 --dof 2' >twice.models
printf '%s\n' "'in here/springs.c' --lagrangian one --dof 1 -o out/x.c -- -DK=1" "'in here/springs.c' --lagrangian one --dof 1 -o out/../out/x.c -- -DK=1" >same.models
expect 2 "open.models:1: a quote is not closed" "$tlgen" --models open.models
expect 2 "none.models names no model" "$tlgen" --models none.models
expect 2 "sarif.models:3: --sarif belongs on the command line" "$tlgen" --models sarif.models
expect 2 "werror.models:2: --werror belongs on the command line" "$tlgen" --models werror.models
expect 2 "twice.models:2: --dof is given twice" "$tlgen" --models twice.models
expect 2 "good.models:2: --dof is given twice" "$tlgen" --models good.models --dof 3
expect 2 "out/x.c would be written twice" "$tlgen" --models same.models
cp good.models kept.models
expect 2 "good.models is a source" "$tlgen" --models good.models --sarif good.models
expect 2 "cannot read missing.models" "$tlgen" --models missing.models
expect 2 "cannot read out" "$tlgen" --models out
cmp good.models kept.models || failed=1
expect_files
exit $failed
