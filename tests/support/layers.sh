#!/usr/bin/env bash
# The order of the folders: pipeline <- raster <- relief <- samples <- { tests, course }. A folder includes only itself
# and what is to its left. The first three compute only: no files, no printing, GLM and the standard library.
# And what could change a byte of a picture from one machine to the next stays out of every way to a pixel.
#   tests/support/layers.sh ROOT        exit 1 with file:line: what is wrong
set -euo pipefail
root=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export LC_ALL=C

mapfile -t files < <("$here/tracked" "$root" '*.hpp' '*.cpp' '*.h')
((${#files[@]})) || { echo "layers: no source file in $root" >&2; exit 1; }
cd "$root"
awk '
    function wrong(text) { print FILENAME ":" FNR ": " text; bad = 1 }
    function is_core(folder) { return folder in rank && rank[folder] <= 3 }
    BEGIN {
        split("pipeline raster relief samples", order, " ")
        for (i in order) rank[order[i]] = i
        rank["tests"] = rank["course"] = 5
        touches_the_world = "^(iostream|fstream|ostream|istream|sstream|cstdio|stdio\\.h|filesystem|syncstream)$"
        changes_bytes = "^(random|unordered_map|unordered_set|execution|valarray)$"
        libm = "(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|fma)f?"
        rounded_by_libm = "(std|glm)::" libm "[ ]*\\("
        printing = "(std::(cout|cerr|clog|printf|puts|fprintf|fopen|fputs)|[^_a-zA-Z0-9.](printf|fprintf|puts|fopen))[^_a-zA-Z0-9]"
    }
    FNR == 1 {
        folder = FILENAME
        sub("/.*", "", folder)
        if (!(folder in rank)) { wrong("this folder has no place in the order of the folders"); nextfile }
        # Shapes are made of the same arithmetic as pixels.
        makes_pixels = is_core(folder) || FILENAME ~ "^samples/scene/shapes/"
        reads_formats = FILENAME ~ "^(samples/(io|scene)|tests)/"
    }
    match($0, "^[ \t]*#[ \t]*include[ \t]*\"[^\"]*\"") {
        path = $0
        sub("^[^\"]*\"", "", path)
        sub("\".*", "", path)
        to = path
        sub("/.*", "", to)
        if (path !~ "/" || !(to in rank)) wrong("\"" path "\": a path starts at the root of the tree: \"pipeline/space.hpp\"")
        else if (to != folder && rank[to] >= rank[folder]) wrong(folder " may not include " path)
        next
    }
    match($0, "^[ \t]*#[ \t]*include[ \t]*<[^>]*>") {
        path = $0
        sub("^[^<]*<", "", path)
        sub(">.*", "", path)
        if (is_core(folder) && path ~ touches_the_world) wrong("<" path ">: " folder " neither reads nor prints")
        if (is_core(folder) && path ~ "[/.]" && path !~ "^glm/" && !(path ~ "^hwy/" && FILENAME ~ "^raster/fast/") && !(path == "sys/mman.h" && FILENAME == "raster/fast/buffer.hpp")) wrong("<" path ">: " folder " stands on GLM and the standard library alone")
        if (makes_pixels && path ~ changes_bytes) wrong("<" path ">: its order or values differ between libraries, and so would pictures")
        if (!reads_formats && path ~ "^(OpenImageIO|toml\\+\\+)/|^(stb_.*|tiny_obj_loader\\.h)$") wrong("<" path ">: files are read and written in samples/io and samples/scene only")
        next
    }
    makes_pixels {
        code = " " $0 " "
        sub("//.*", " ", code)
        gsub("\"[^\"]*\"", "\"\"", code)
        if (is_core(folder) && code ~ printing) wrong(folder " neither reads nor prints")
        if (code ~ rounded_by_libm) wrong("rounded differently by each libm: pipeline/elementary.hpp has its own")
    }
    END { exit bad }
' "${files[@]}"
