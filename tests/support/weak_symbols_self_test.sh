#!/usr/bin/env bash
# The check of weak symbols can fail.      weak_symbols_self_test.sh COMPILER
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir good bad none
printf 'namespace N_AVX2 { inline int g() { return 1; } }\nstatic int h() { return 2; }\nint f() { return N_AVX2::g() + h(); }\n' >good/stages_avx2.cpp
printf 'inline int g() { return 1; }\nint f() { return g(); }\n' >bad/stages_avx2.cpp
printf 'int f() { return 1; }\n' >none/other.cpp
for source in good/stages_avx2 bad/stages_avx2 none/other; do
    "$1" -O0 -c "$source.cpp" -o "$source.cpp.o"
    ar rc "${source%/*}/library.a" "$source.cpp.o"
done
"$here/weak_symbols.sh" good/library.a
for name in bad none; do
    if "$here/weak_symbols.sh" "$name/library.a" >/dev/null 2>&1; then
        echo "$name passed" >&2
        exit 1
    fi
done
