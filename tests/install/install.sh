#!/usr/bin/env bash
# install.sh BUILD PREFIX: installs into an empty folder, then checks that what is promised is there and nothing names the build tree.
set -euo pipefail
build=$1 prefix=$2
rm -rf "$prefix"
cmake --install "$build" --prefix "$prefix" >/dev/null
for file in include/taylor/taylor.h include/eom/eom.h; do
  [ -f "$prefix/$file" ] || { echo "missing: $file"; exit 1; }
done
if grep -rlI --include='*.cmake' --include='*.h' -e "$build" "$prefix"; then
  echo "these installed files name the build tree"
  exit 1
fi
