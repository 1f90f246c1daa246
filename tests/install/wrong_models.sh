#!/usr/bin/env bash
# wrong_models.sh SOURCE TREE OPTION..: calls of taylor_add_model that lack or confuse something end with a message that says what, and how.
set -uo pipefail
source=$1 tree=$2
shift 2
rm -rf "$tree"
mkdir -p "$tree"
failed=0

# expect TEXT CALL: configuring a project with that call fails and says TEXT, whatever its line breaks.
expect() {
  printf 'set(CMAKE_CURRENT_SOURCE_DIR %s)\n%s\n' "$source" "$2" >"$tree/call.cmake"
  if cmake -S "$source" -B "$tree/build" -DCALL="$tree/call.cmake" "${options[@]}" >"$tree/said" 2>&1; then
    [ "$1" = "" ] || { echo "accepted: $2"; failed=1; }
  elif said=$(tr -s ' \n' ' ' <"$tree/said") && [ "$1" = "" ] || [[ "$said" != *"$1"* ]] ||
    [[ "$said" != *"taylor_add_model(pendulum SOURCES pendulum.c LAGRANGIAN lagrangian DOF 2)"* ]]; then
    echo "$2: not said, or no example: $1"
    cat "$tree/said"
    failed=1
  fi
}
options=("$@")

expect "" "taylor_add_model(fall SOURCES fall.c LAGRANGIAN lagrangian DOF 1)"
expect "take the place of the library -lm " "taylor_add_model(m SOURCES fall.c LAGRANGIAN lagrangian DOF 1)"
expect "take the place of the library -ldl " "taylor_add_model(dl SOURCES fall.c LAGRANGIAN lagrangian DOF 1)"
expect "there is a target of that name already" "add_custom_target(fall)
taylor_add_model(fall SOURCES fall.c LAGRANGIAN lagrangian DOF 1)"
expect "'my-fall' cannot be a model's name in C; add MODEL name" "taylor_add_model(my-fall SOURCES fall.c LAGRANGIAN lagrangian DOF 1)"
expect "" "taylor_add_model(my-fall MODEL fall SOURCES fall.c LAGRANGIAN lagrangian DOF 1)"
expect "SOURCES is missing" "taylor_add_model(fall LAGRANGIAN lagrangian DOF 1)"
expect "DOF is missing" "taylor_add_model(fall SOURCES fall.c LAGRANGIAN lagrangian)"
expect "LAGRANGIAN is missing" "taylor_add_model(fall SOURCES fall.c DOF 1)"
expect "DOF wants a value" "taylor_add_model(fall SOURCES fall.c LAGRANGIAN lagrangian DOF)"
expect "unknown arguments: DEGREES 1" "taylor_add_model(fall DEGREES 1 SOURCES fall.c LAGRANGIAN lagrangian)"
expect "there is no source file" "taylor_add_model(fall SOURCES fell.c LAGRANGIAN lagrangian DOF 1)"
exit $failed
