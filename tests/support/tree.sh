#!/usr/bin/env bash
# What the tree is made of: our own text, at home on any machine, every test on.
#   tests/support/tree.sh ROOT          exit 1 with what is wrong
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mapfile -t files < <("$here/tracked" "$1")
((${#files[@]})) || { echo "tree: no file in $1" >&2; exit 1; }
cd "$1"
bad=0

# Folders of one machine. Those of every Debian (/usr, /etc, /dev, /proc) may be named.
if grep -nIE '(^|[^A-Za-z0-9_.~}/-])/(work|home|root|tmp|farm|mnt|media|opt|srv|Users)/[A-Za-z0-9_.]' -- "${files[@]}"; then
    echo "  ^ paths of one machine: make them relative, or ask mktemp"
    bad=1
fi
# Libraries come from Debian packages, when building, and stay out of the tree.
if printf '%s\n' "${files[@]}" | grep -iE \
    '(^|/)(stb_[a-z_]+\.h|tiny_obj_loader\.[a-z]+|toml\.hpp|CLI11\.hpp|json\.hpp|catch\.hpp|doctest\.h|(third[-_]?party|vendor|external|extern|deps)/.*|\.gitmodules)$'; then
    echo "  ^ third-party code: take it from its Debian package"
    bad=1
fi
mapfile -t recipes < <(printf '%s\n' "${files[@]}" | grep -E '(^|/)CMakeLists\.txt$|\.cmake$' || true)
if ((${#recipes[@]})) && grep -nE 'FetchContent|ExternalProject|file *\( *DOWNLOAD' -- "${recipes[@]}"; then
    echo "  ^ nothing is downloaded but Debian packages"
    bad=1
fi
# A test that does not run is a failing test.
mapfile -t tests < <(printf '%s\n' "${files[@]}" | grep -E '^tests/.*\.[ch]pp$' || true)
if ((${#tests[@]})) && grep -nE 'GTEST_[S]KIP|[(, ]DISABLED_' -- "${tests[@]}"; then
    echo "  ^ tests that do not run: repair or delete them"
    bad=1
fi
exit "$bad"
