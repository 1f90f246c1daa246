# What the tests of the drivers share; sourced. Each test runs in an empty folder of its own that is removed at the end.
set -uo pipefail
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
mkdir scratch # for out.txt and err.txt of run, so that the folder itself holds what the program left

fail() {
  echo "FAILED: $*"
  for text in scratch/out.txt scratch/err.txt; do
    [ -s $text ] && { echo "-- $text"; tail -n 40 $text; }
  done
  exit 1
}

# run STATUS COMMAND..: runs it with no terminal; fails where its exit status is another one.
run() {
  local wanted=$1 status
  shift
  "$@" >scratch/out.txt 2>scratch/err.txt </dev/null
  status=$?
  [ $status -eq "$wanted" ] || fail "exit status $status, not $wanted, of: $*"
}

# says FILE PATTERN: fails where no line of the file matches the extended regular expression.
says() {
  grep -Eq -- "$2" "$1" || fail "$1 does not say: $2"
}

# leaves NAME..: fails where the folder holds anything else than these.
leaves() {
  local found wanted
  found=$(ls -A | grep -vx scratch)
  wanted=$(printf '%s\n' "$@" | sort)
  [ "$(sort <<<"$found")" = "$wanted" ] || fail "files left: $(tr '\n' ' ' <<<"$found"); wanted: $*"
}

# full_device NAME: a device that is always full. For root a node of its own, so that a program that replaces what it should write to
# cannot take /dev/full away from the machine; else, or where nodes cannot be made, a link to /dev/full.
full_device() {
  if [ "$(id -u)" -eq 0 ] && mknod "$1" c 1 7 2>/dev/null; then
    [[ $( (echo x >"$1") 2>&1) == *'No space left'* ]] && return
    rm "$1"
  fi
  ln -s /dev/full "$1"
}
