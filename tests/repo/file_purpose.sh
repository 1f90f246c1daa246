#!/usr/bin/env bash
# The first line of each source, build file and script (the second after an interpreter line) is a comment that says its purpose.
set -euo pipefail
git rev-parse --is-inside-work-tree >/dev/null 2>&1 || { echo "not a git checkout: skipped"; exit 77; }
bad=0
while IFS= read -r file; do
  line=$(sed -n '1{/^#!/!{p;q}};2{p;q}' "$file")
  case "$file:$line" in
    *.py:\"\"\"?* | *.c:/[*/]\ * | *.h:/[*/]\ * | *.cpp:/[*/]\ * | *:\#\ *) ;;
    *) echo "$file:1: no comment says what this file is for: $line"; bad=1 ;;
  esac
done < <(git ls-files '*.c' '*.h' '*.cpp' '*.cmake' '*CMakeLists.txt' '*.sh' '*.py' scripts .ci ':!tests/tlgen' ':!examples/models')
exit $bad
