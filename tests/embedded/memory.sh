#!/usr/bin/env bash
# Flash, and memory with the worst-case stack, of the firmware's images, within what they may take; and that memory.py sees what may not
# be in them. Ends with 77 where there is no cross compiler.
#   memory.sh TLGEN SOURCE-FOLDER FOLDER      FOLDER: as firmware_build.sh has left it
set -euo pipefail
tlgen=$1 root=$2 built=$3
for tool in arm-none-eabi-gcc python3 make; do command -v $tool >/dev/null || { echo "no $tool here"; exit 77; }; done
fail() { echo "$*"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

within() { # IMAGE MODEL FLASH MEMORY-AND-STACK
  local taken
  taken=$(python3 "$root/examples/firmware/memory.py" "$built/$1" "$built/$2")
  echo "$1: $taken"
  awk -v flash="$3" -v ram="$4" '{ exit !($1 > 0 && $1 <= flash && $3 > 100 && $2 + $3 <= ram) }' <<<"$taken" || fail "$1 takes too much"
}
within 1-float-m4f cart_pole-float 32768 4096
within 1-float-m3 cart_pole-float 32768 4096
within 1-double-m7 cart_pole-double 36864 4096
within 2-float-m4f double_cart_pole-float 36864 4096
within 2-float-m3 double_cart_pole-float 40960 4096
within 2-double-m7 double_cart_pole-double 45056 8192

# In a copy of the firmware: functions that run in each control step.
mkdir "$work/copy"
cp -r "$root/examples/firmware" "$root/examples/models" "$work/copy"
sees() { # TEXT CODE
  sed "s|^int controller_step(|$2\n&|; s|^  keep(c);|  if (canary(c->mode) == 7) return 1;\n&|" "$root/examples/firmware/controller.c" >"$work/copy/firmware/controller.c"
  make -s -C "$work/copy/firmware" TLGEN="$tlgen" OUT="$work" BOARD=m4f >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
  ! python3 "$work/copy/firmware/memory.py" "$work/1-float-m4f" "$work/cart_pole-float" >"$work/said" 2>&1 || fail "goes unseen: $2"
  grep -q "$1" "$work/said" || { cat "$work/said"; fail "not told as '$1'"; }
}
sees 'recursion' '__attribute__((noinline)) static int canary(int n) { volatile int m = n; return m > 0 ? canary(m - 1) + m : 0; }'
sees 'allocates' '__attribute__((noinline)) void *malloc(size_t n) { return n > 0 ? (void *)(n + 1) : NULL; }\nstatic int canary(int n) { int *volatile p = malloc((size_t)n); return p ? *p : 0; }'
sees 'frame of unknown size' '__attribute__((noinline)) static int canary(int n) { volatile char *p = __builtin_alloca((unsigned)n); p[0] = 1; return p[0]; }'
