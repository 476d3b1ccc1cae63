#!/usr/bin/env bash
# The tree check can fail: each planted mistake is found, and a right tree passes.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
git -c init.defaultBranch=main init -q "$tree"
printf 'see /usr/share/doc, https://example.org/home/page and ../home/x\n' >"$tree/README.md"

check() {  # FILE TEXT EXPECTED: the check says EXPECTED, or nothing when it is empty
    mkdir -p "$tree/$(dirname "$1")"
    printf '%s\n' "$2" >"$tree/$1"
    local said status=0 expected=${3:+1}
    said=$("$here/tree.sh" "$tree") || status=$?
    rm "$tree/$1"
    if [ "$status" != "${expected:-0}" ] || [[ $said != *"$3"* ]]; then
        echo "$1: $2: said '$said', status $status" >&2
        exit 1
    fi
}
home=/home
check a.txt 'nothing' ''
check a.txt "see $home/someone/file" 'paths of one machine'
check "raster/a.cpp" "open(\"$home/x\")" 'paths of one machine'
check third_party/a.cpp 'int x;' 'third-party'
check samples/stb_image.h 'int x;' 'third-party'
check raster/CMakeLists.txt 'include(FetchContent)' 'nothing is downloaded'
check tests/a.cpp 'TEST(A, DISABLED_b) {}' 'do not run'
