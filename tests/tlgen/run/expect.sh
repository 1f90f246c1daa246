# What the tests of this folder share; sourced with the work folder as the current one.
failed=0

# expect STATUS TEXT COMMAND..: the command ends with that status and says TEXT; what it said stays in the file "said".
expect() {
  local status=$1 text=$2 got=0
  shift 2
  "$@" >said 2>&1 || got=$?
  if [ $got != "$status" ] || [[ "$(cat said)" != *"$text"* ]]; then
    echo "$*: exit status $got, not $status, or not: $text"
    cat said
    failed=1
  fi
}

# expect_files NAME..: these files and no others are in the folder out, which is then emptied.
expect_files() {
  local wanted found
  wanted=$(printf '%s\n' "$@" | sort)
  found=$(cd out && find . -type f -printf '%P\n' | sort)
  [ "$wanted" = "$found" ] || { echo "in out: $found"; echo "expected: $wanted"; failed=1; }
  rm -rf out
  mkdir out
}
