#!/usr/bin/env bash
# The README's C++ program is samples/minimal/teapot.cpp, letter by letter, its scene can be drawn, and its picture is
# what the program draws today.
#   readme.sh ROOT RELEVO
set -euo pipefail
root=$1 relevo=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
block() { awk -v start="\`\`\`$1" '$0 == "```" { inside = 0 } inside { print } $0 == start { inside = 1 }' "$root/README.md"; }

block cpp >"$folder/teapot.cpp"
diff "$root/samples/minimal/teapot.cpp" "$folder/teapot.cpp" ||
    { echo "README.md and samples/minimal/teapot.cpp differ: make them the same" >&2; exit 1; }

block toml >"$folder/first.toml"
[ "$(wc -l <"$folder/first.toml")" -ge 15 ] || { echo "README.md has no scene" >&2; exit 1; }
"$relevo" render "$folder/first.toml" -o "$folder/first.png"
[ -s "$folder/first.png" ]

"$relevo" steps "$root/samples/scenes/still_life.toml" -o "$folder/still_life"
"$relevo" compare "$root/samples/strip.png" "$folder/still_life/strip.png" ||
    { echo "samples/strip.png is not what the demo draws: copy out/still_life/strip.png over it" >&2; exit 1; }

"$relevo" steps "$root/samples/scenes/lessons/figure-5-2.toml" -o "$folder/lesson"
"$relevo" compare "$root/samples/lesson.png" "$folder/lesson/01-line-midpoint/003.png" ||
    { echo "samples/lesson.png is not what the lesson shows: copy its 01-line-midpoint/003.png over it" >&2; exit 1; }

"$relevo" render "$root/samples/scenes/relief/ways.toml" -o "$folder/ways.png"
"$relevo" compare "$root/samples/ways.png" "$folder/ways.png" ||
    { echo "samples/ways.png is not what its scene draws: relevo render samples/scenes/relief/ways.toml" >&2; exit 1; }

"$relevo" steps "$root/samples/scenes/relief/bumpy.toml" -o "$folder/bumpy" --stage relief-field
"$relevo" compare "$root/samples/relief_stage.png" "$folder/bumpy/20-relief-field.png" ||
    { echo "samples/relief_stage.png is not the stage relief-field of samples/scenes/relief/bumpy.toml" >&2; exit 1; }
