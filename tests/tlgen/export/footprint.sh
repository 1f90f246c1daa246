#!/usr/bin/env bash
# What an export takes on three boards: within its budget, the same in each run, failures told by status; and footprint.py notices what
# firmware may not contain. Ends with 77 where there is no cross compiler or no emulator.
#   footprint.sh TLGEN FOLDER-OF-MODELS FOLDER-OF-GOLDEN
set -euo pipefail
tlgen=$1 models=$2 golden=$3
for tool in arm-none-eabi-gcc qemu-system-arm python3; do command -v $tool >/dev/null || { echo "no $tool here"; exit 77; }; done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "$*"; exit 1; }
cart=("$models/cart_pole.c" --lagrangian cart_pole_lagrangian --force cart_pole_force --dof 2)
bead=("$golden/bead.c" --lagrangian bead_lagrangian --force bead_drag --holonomic bead_wire --dof 2)

# Budgets in bytes: flash, then memory and stack together.
within() { # FOLDER FLASH RAM: reads the table
  awk -v flash="$2" -v ram="$3" -v of="$1" '$1 ~ /^m(3|4f|7)$/ { n++; if ($3 > flash || $4 + $5 > ram || $7 != 0) { print of ": " $0; bad = 1 } }
    END { exit bad || n == 0 }' "$1/MANIFEST" || fail "$1: beyond its budget, or a status other than 0"
}
"$tlgen" "${cart[@]}" --export cart --real float
python3 cart/footprint.py --no-misra >first
within cart 32768 4096
python3 cart/footprint.py --no-misra --boards m4f --paint >second
cmp <(grep '^m4f' first) <(grep '^m4f' second) || fail "another run counts otherwise"
"$tlgen" "${cart[@]}" --export cart # in double, over the measured one
grep -q 'not measured yet' cart/MANIFEST || fail "an old measurement was kept"
python3 cart/footprint.py --no-misra --boards m7 >/dev/null
within cart 32768 4096
"$tlgen" "${bead[@]}" --export bead --real float
python3 bead/footprint.py --no-misra --boards m3 --paint >painted
[ "$(grep -c '^stack of' second painted)" = $'second:3\npainted:3' ] || fail "not every stack was painted"
sed 's/return self.frame.get(root, 0) + deepest/return self.frame.get(root, 0)/' bead/footprint.py >bead/shallow.py
! python3 bead/shallow.py --no-misra --boards m3 --paint >said 2>&1 || fail "a stack deeper than computed goes unseen"
grep -q 'takes .* bytes of stack' said || { cat said; fail "a stack deeper than computed is told otherwise"; }
rm bead/shallow.py
python3 bead/footprint.py --no-misra >/dev/null
within bead 65536 8192

# Not a warning on a processor without a floating-point unit either, of the board's own file too.
(cd bead && for source in *.c src/*.c board/*.c; do
  arm-none-eabi-gcc -mcpu=cortex-m3 -mthumb -std=c11 -Os -Wall -Wextra -Wconversion -Wno-sign-conversion -Wdouble-promotion -Wpedantic -Wundef \
    -Wcast-align -Wstrict-prototypes -Wmissing-prototypes -Werror -DNEED=example_step -DEXAMPLE_WITHOUT_MAIN -I. -Iinclude -c "$source" -o "$work/object"
done) || fail "a warning"

# A mass matrix that is singular, and a function without a value: a status, and the board goes on.
"$tlgen" "${cart[@]}" --export massless --real float
sed -i 's/\(cart_mass\|pole_mass\) = TL_C(1.0)/\1 = TL_C(0.0)/' massless/main.c
"$tlgen" "$models/kepler.c" --lagrangian kepler_lagrangian --dof 2 --export centre --real float
sed -i 's/y\[2 \* N\] = {[^}]*}/y[2 * N] = {TL_C(0.0)}/' centre/main.c
for broken in massless centre; do
  python3 $broken/footprint.py --no-misra --boards m4f,m3 >/dev/null || fail "$broken: the board stopped"
  awk '$1 ~ /^m(3|4f|7)$/ { n++; if ($7 == 0) bad = 1 } END { exit bad || n == 0 }' $broken/MANIFEST || fail "$broken: no status tells"
done

# A square root is one instruction, without the C library's function, whose errno brings a kilobyte of memory.
printf '#include <math.h>\ndouble L(const double *q, const double *qd) { return 0.5 * qd[0] * qd[0] - sqrt(1.0 + q[0] * q[0]); }\n' >root.c
"$tlgen" root.c --lagrangian L --dof 1 --export root --real float
python3 root/footprint.py --no-misra --boards m4f >/dev/null
awk '$1 == "m4f" && $2 == "simulate" { n++; if ($4 > 256) { print; bad = 1 } } END { exit bad || n != 1 }' root/MANIFEST || fail "a square root costs memory"

# What must not be there is noticed.
"$tlgen" "${cart[@]}" --export canary --real float
cp canary/main.c good.c
notices() { # TEXT CODE: code that example_simulate runs
  sed "s|^int example_simulate(void) {|$2\nint example_simulate(void) { if (canary(3) == 7) return 1;|" good.c >canary/main.c
  ! python3 canary/footprint.py --no-misra --boards m4f >said 2>&1 || fail "goes unseen: $2"
  grep -q "$1" said || { cat said; fail "not told as '$1'"; }
}
notices 'allocates' '#include <stdlib.h>\nstatic int canary(int n) { int *volatile p = malloc((size_t)n); return p ? *p : 0; }'
notices 'recursion' '__attribute__((noinline)) static int canary(int n) { volatile int m = n; return m > 0 ? canary(m - 1) + m : 0; }'
notices 'frame of unknown size' '__attribute__((noinline)) static int canary(int n) { volatile char *p = __builtin_alloca((unsigned)n); p[0] = 1; return p[0]; }'
notices 'vla' 'static int canary(int n) { volatile char p[n]; p[0] = 1; return p[0]; }'
notices 'in double' 'static int canary(int n) { volatile double x = n; x = x * x; return (int)x; }'
notices 'double-promotion\|implicitly' 'static int canary(int n) { volatile float x = (float)n; volatile double y = x * 0.1; return (int)y; }'
notices 'somebody unknown' 'static int (*volatile stranger)(int); __attribute__((noinline)) static int canary(int n) { return stranger(n); }'

if command -v cppcheck >/dev/null; then
  for folder in cart bead; do
    python3 $folder/footprint.py --boards m7 >/dev/null
    [ "$(wc -l <$folder/MISRA)" -gt 10 ] || fail "$folder: cppcheck found too little to be believed"
    ! grep 'NOT LOOKED AT' $folder/MISRA || fail "$folder: a MISRA rule without a reason"
  done
fi
