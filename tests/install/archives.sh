#!/usr/bin/env bash
# archives.sh BUILD VERSION [FILE..]: CPack makes a .tar.gz and a .deb that hold the library, the headers, the CMake package and these files.
set -euo pipefail
build=$1 version=$2
shift 2
cd "$build"
rm -f ./libtaylor*.deb ./libtaylor*.tar.gz
cpack >cpack.log 2>&1 || { cat cpack.log; exit 1; }
for listing in "$(tar tzf libtaylor-"$version"-*.tar.gz)" "$(dpkg-deb -c libtaylor_"$version"_*.deb)"; do
  for file in libtaylor.a taylor/taylor.h eom/eom.h libtaylorConfig.cmake "$@"; do
    grep -q "/$file\$" <<<"$listing" || { echo "$file is missing from"; echo "$listing"; exit 1; }
  done
done
