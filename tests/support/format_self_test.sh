#!/usr/bin/env bash
# The format check can fail: it passes a well-set file and refuses a badly set one.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
git -c init.defaultBranch=main init -q "$tree"
cp "$here/../../.clang-format" "$tree"

printf 'int f(int x) { return x; }\n' >"$tree/a.cpp"
"$here/format.sh" "$tree"
printf 'int  f(int x){return x;}\n' >"$tree/a.cpp"
if "$here/format.sh" "$tree" 2>/dev/null; then
    echo "a badly set file passed" >&2
    exit 1
fi
