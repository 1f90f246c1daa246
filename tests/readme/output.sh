#!/usr/bin/env bash
# output.sh FOLDER PROGRAM: the example prints what the page says it prints.
set -euo pipefail
diff "$1/output.txt" <("$2")
