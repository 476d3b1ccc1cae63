#!/usr/bin/env bash
# `relevo steps` on the bunny from one pixel to 2048 x 2048: all seventeen stages each time, the same bytes twice.
#   steps_test.sh RELEVO
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf '[[object]]\nmesh = "/usr/share/glmark2/models/bunny.obj"\n' >"$work/bunny.toml"
fail() { echo "steps: $*" >&2; exit 1; }

sums() { (cd "$1" && sha256sum -- $(ls | grep -v timing)); }
stages=(object world eye clip clipped ndc window culled coverage depth visibility attributes flat gouraud phong texture final)
for size in 1x1 7x5 2048x2048; do
    "$1" steps "$work/bunny.toml" -o "$work/$size" --size "$size" 2>"$work/said" || fail "$size: $(cat "$work/said")"
    number=0
    for stage in "${stages[@]}"; do
        number=$((number + 1))
        picture=$(printf '%s/%02d-%s.png' "$work/$size" "$number" "$stage")
        [ -s "$picture" ] || fail "$size: no ${picture##*/}"
    done
    leftovers=$(find "$work/$size" -mindepth 1 ! -name '*.png' ! -name '*.json' ! -name index.html)
    [ -z "$leftovers" ] || fail "$size: what is $leftovers?"
    grep -q '69,\?666' "$work/$size/steps.json" || fail "$size: steps.json does not tell the number of triangles"
done
"$1" steps "$work/bunny.toml" -o "$work/again" --size 7x5
[ "$(sums "$work/7x5")" = "$(sums "$work/again")" ] || fail "twice the same scene, two different folders"
