#!/usr/bin/env bash
# The check of compiled code can fail: it passes a square root and refuses a sine.      no_libm_self_test.sh COMPILER
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
printf '#include <cmath>\nfloat f(float x) { return std::sqrt(x); }\n' >good.cpp
printf '#include <cmath>\nfloat f(float x) { return std::sin(x); }\n' >bad.cpp
for name in good bad; do "$1" -c "$name.cpp" -o "$name.o"; done
"$here/no_libm.sh" good.o
if "$here/no_libm.sh" bad.o >/dev/null; then
    echo "a call of sin passed" >&2
    exit 1
fi
