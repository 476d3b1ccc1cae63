#!/usr/bin/env bash
# Starting the program is cheap: `relevo --version` runs at most 5 million instructions more than a program that does
# nothing, most of them the system's loader. (5 million are some 2 ms.)
#   start_test.sh RELEVO
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
count() {
    valgrind -q --tool=callgrind --callgrind-out-file="$work/out" "$@" >/dev/null
    sed -n 's/^totals: *//p' "$work/out"
}
nothing=$(count /bin/true)
version=$(count "$1" --version)
echo "relevo --version: $version instructions; /bin/true: $nothing"
((version - nothing <= 5000000))
