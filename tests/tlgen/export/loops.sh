#!/usr/bin/env bash
# Every loop of libtaylor, of the runtime's core and of what tlgen prints either counts to a bound (loops.py) or is in loops.txt, with what
# ends it.
#   loops.sh TLGEN SOURCE-FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
tlgen=$1 root=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
models=$root/examples/models
"$tlgen" "$models/snakeboard.c" --lagrangian snakeboard_lagrangian --holonomic snakeboard_drives:3 --nonholonomic snakeboard_slips:2 --dof 6 \
  --export constrained >/dev/null 2>&1
"$tlgen" "$models/pendulum.c" --lagrangian pendulum_lagrangian --dof n --size n=20 --export chain >/dev/null # in rows
mapfile -t sources < <(find "$root/libtaylor/src" "$root/libtaylor/include" "$root/runtime/src" "$root/runtime/include" \
  -name '*.[ch]' ! -name '*_host.c' ! -name '*_lapacke.c')
[ ${#sources[@]} -gt 60 ]
loops_of() { python3 "$here/loops.py" "$@" | sort -u; }
loops_of "${sources[@]}" constrained/{main,snakeboard_tl}.c chain/{main,pendulum_tl}.c >found
grep -v '^#' "$here/loops.txt" | sed 's/  *-- .*//' | sort >kept
diff kept found || { echo "loops.txt does not say what ends each loop"; exit 1; }

# Each of these is seen.
while read -r loop; do
  echo "static void forever(int n, struct list *p) { int i = 0; $loop }" >canary.c
  [ "$(loops_of canary.c | wc -l)" = 1 ] || { echo "goes unseen: $loop"; exit 1; }
done <<'L'
while (1) { }
for (;;) { }
for (i = 0; i < n;) { }
for (i = 0;; i++) { }
for (i = 0; i < n; i++) i--;
for (i = 0; i < n; i++) { if (n == 3) { i = 0; } }
for (i = 0; i < n || p; i++) { }
for (; p; p = p->next) { }
do { i++; } while_not(i);
again: i++; goto again;
L
for loop in 'for (i = 0; i < n; i++) { if (i == n) return; }' 'for (int step = 16; step > 0; step /= 2) n += step;'; do
  echo "static void forever(int n) { int i; $loop }" >canary.c
  [ -z "$(loops_of canary.c)" ] || { echo "thought endless: $loop"; exit 1; }
done
