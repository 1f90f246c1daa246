#!/usr/bin/env bash
# What the firmware does on a host, and from several starts.
#   firmware_host.sh SOURCE-FOLDER FOLDER WHAT [POLES]      FOLDER: as firmware_build.sh has left it. WHAT:
#     starts POLES       from several starts, with a machine that is not quite the expected one, the poles come to stand
#     board POLES        from some of them on an emulated Cortex-M4F, too, and to the bit as on the host
#     plan               the motion in flash is the optimum that plan.c computes beside it, and plan.c finds a motion from nothing, too
#     plot               plot.gp draws its CSV
set -euo pipefail
root=$1 built=$2 what=$3 poles=${4:-1}
source=$root/examples/firmware
[ -x "$built/2-float-host" ] || { echo "no firmware here"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$*"; exit 1; }
flags=(-std=c11 -O2 -fno-math-errno -ffp-contract=off -DTL_SOFT_NUMBERS=0 -Wall -Wextra -Werror -I"$source")

case $what in
  starts | board)
    export=$built/$([ "$poles" = 1 ] && echo cart_pole || echo double_cart_pole)-float
    swing=("$source/swing_1.c")
    [ "$poles" = 1 ] || swing=("$source/swing_2.c" "$source/reference.c" "$source/reference_table.c")
    build() { # COMPILER CONSOLE ARGUMENT..
      local compiler=$1 console=$2
      shift 2
      "$compiler" "${flags[@]}" "$@" -DPLANT_POLES="$poles" -I"$export" -I"$export/include" "$root/tests/embedded/starts.c" \
        "$source/"{loop,controller,riccati,plant,text,"$console"}.c "${swing[@]}" "$export/"*_tl.c "$export/src/"*.c -lm -o "$work/starts"
    }
    if [ "$what" = starts ]; then
      build cc console_host -fsanitize=undefined -fno-sanitize-recover=all
      "$work/starts" || fail "the poles have not come up"
      exit
    fi
    for tool in arm-none-eabi-gcc qemu-system-arm; do command -v $tool >/dev/null || { echo "no $tool here"; exit 77; }; done
    build cc console_host -DSTARTS_SOME -DNDEBUG
    "$work/starts" >"$work/host"
    build arm-none-eabi-gcc console_board -DSTARTS_SOME -DNDEBUG -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -nostartfiles \
      -T "$export/board/board.ld" -ffunction-sections -fdata-sections -Wl,--gc-sections
    qemu-system-arm -machine mps2-an386 -nographic -monitor none -serial none -semihosting-config enable=on,target=native -kernel "$work/starts" \
      >"$work/board" 2>&1 || { cat "$work/board"; fail "the poles have not come up on the board"; }
    cat "$work/board"
    [ "$(wc -l <"$work/board")" = 3 ] || fail "not every start was run"
    cmp "$work/board" "$work/host"
    ;;
  plan)
    python3 "$root/tests/embedded/firmware.py" table "$source/reference_table.c" <("$built/plan")
    "$built/plan" new >"$work/new.c"
    python3 "$root/tests/embedded/firmware.py" planned "$work/new.c"
    sed 's/e+00f, 3\.14/e+00f, 2.14/' "$work/new.c" >"$work/wrong.c"
    ! python3 "$root/tests/embedded/firmware.py" planned "$work/wrong.c" >/dev/null 2>&1 || fail "a motion from elsewhere goes unseen"
    sed '8s/[1-9]\.[1-9]/9.9/' "$source/reference_table.c" >"$work/wrong.c"
    ! python3 "$root/tests/embedded/firmware.py" table "$work/wrong.c" "$source/reference_table.c" >/dev/null 2>&1 || fail "a wrong table goes unseen"
    ;;
  plot)
    command -v gnuplot >/dev/null || { echo "no gnuplot here"; exit 77; }
    for poles in 1 2; do
      "$built/$poles-float-host" >"$work/run.csv"
      draw() { (cd "$work" && gnuplot -e "csv='$1'; svg='run.svg'; poles=$poles" "$source/plot.gp"); }
      draw run.csv
      for text in 'cart, m' 'push, N' 't, s' "pole $poles" "estimate $poles"; do
        grep -q ">$text<" "$work/run.svg" || grep -q "<tspan[^>]*>$text" "$work/run.svg" || fail "no '$text' in the drawing"
      done
      # A line of each column: gnuplot puts their points into path elements.
      [ "$(grep -o '[ML][0-9.]*,[0-9.]*' "$work/run.svg" | wc -l)" -gt 800 ] || fail "too few points are drawn"
      sed '1s/,push,/,pull,/' "$work/run.csv" >"$work/wrong.csv"
      ! draw wrong.csv >/dev/null 2>&1 || fail "a column that is not there goes unseen"
    done
    ;;
  *) fail "nothing of the name $what" ;;
esac
