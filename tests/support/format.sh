#!/usr/bin/env bash
# Every C++ file is as clang-format 14 leaves it.
#   tests/support/format.sh ROOT            to repair: clang-format-14 -i FILE
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mapfile -t files < <("$here/tracked" "$1" '*.hpp' '*.cpp')
((${#files[@]})) || { echo "format: no source file in $1" >&2; exit 1; }
cd "$1"
clang-format-14 --dry-run -Werror --ferror-limit=1 -- "${files[@]}"
