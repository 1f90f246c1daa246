#!/usr/bin/env bash
# The top CMakeLists.txt stays under 100 lines: what belongs to a part stands in that part's folder.
set -euo pipefail
limit=100
lines=$(wc -l <CMakeLists.txt)
echo "CMakeLists.txt: $lines lines, must be under $limit"
[ "$lines" -lt $limit ]
