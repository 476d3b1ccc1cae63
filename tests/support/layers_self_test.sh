#!/usr/bin/env bash
# The layer check can fail: each planted mistake is found, in its line, and a right tree passes.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
git -c init.defaultBranch=main init -q "$tree"

check() {  # FILE LINE EXPECTED: the check says FILE:1 EXPECTED, or nothing when EXPECTED is empty
    mkdir -p "$tree/$(dirname "$1")"
    printf '%s\n' "$2" >"$tree/$1"
    local said status=0
    said=$("$here/layers.sh" "$tree") || status=$?
    rm "$tree/$1"
    if [ -z "$3" ]; then
        [ "$status" = 0 ] && [ -z "$said" ] || { echo "refused: $1: $2 ($said)" >&2; exit 1; }
    elif [ "$status" != 1 ] || [[ $said != "$1:1: "*"$3"* ]]; then
        echo "not found: $1: $2 (said '$said', status $status)" >&2
        exit 1
    fi
}

check pipeline/a.hpp '#include "pipeline/b.hpp"' ''
check raster/a.cpp '#include "pipeline/b.hpp"' ''
check raster/a.cpp '#include <glm/glm.hpp>' ''
check samples/show/a.cpp '#include <fstream>' ''
check tests/raster/a.cpp '#include "samples/io/b.hpp"' ''
check raster/a.hpp '// std::sin(x) is what this is not: it calls printf("") nowhere' ''
check raster/a.hpp 'x = elementary::sin(y);' ''

check pipeline/a.hpp '#include "raster/b.hpp"' 'pipeline may not include raster/b.hpp'
check raster/a.cpp '  #  include "samples/b.hpp"' 'raster may not include samples/b.hpp'
check relief/a.cpp '#include "tests/b.hpp"' 'relief may not include'
check samples/io/a.cpp '#include "tests/b.hpp"' 'samples may not include'
check tests/a.cpp '#include "course/b.hpp"' 'tests may not include'
check course/a.cpp '#include "tests/b.hpp"' 'course may not include'
check raster/a.hpp '#include "image.hpp"' 'starts at the root'
check raster/a.hpp '#include "../pipeline/b.hpp"' 'starts at the root'
check other/a.cpp 'int x;' 'no place'
check pipeline/a.hpp '#include <iostream>' 'neither reads nor prints'
check raster/a.cpp '#include <cstdio>' 'neither reads nor prints'
check raster/a.cpp 'void f() { std::printf("x"); }' 'neither reads nor prints'
check relief/a.cpp 'printf("x");' 'neither reads nor prints'
check raster/a.cpp '#include <fmt/core.h>' 'GLM and the standard library alone'
check raster/fast/a.cpp '#include <sys/mman.h>' 'GLM and the standard library alone'
check samples/show/a.cpp '#include <toml++/toml.h>' 'samples/io and samples/scene only'
check raster/a.cpp '#include <unordered_map>' 'so would pictures'
check samples/scene/shapes/a.cpp 'y = std::sin(x);' 'each libm'
check raster/a.hpp 'y = glm::pow (x, 2.0f);' 'each libm'
