#!/usr/bin/env bash
# Fused multiply-adds change pixels, and the comparison with the textbook path sees it: of a program whose stages were
# compiled with -ffp-contract=fast no AVX2 or AVX-512 picture is right, and neither is the textbook path's own if that
# was. (SSE4 has no such instruction.)
#   identity_fused_test.sh PLAIN STAGES_FUSED TEXTBOOK_FUSED      three builds of identity_sums.cpp
set -euo pipefail
plain=$("$1") stages=$("$2") textbook=$("$3")
right=$(sed -n 's/^textbook //p' <<<"$plain")
fail() { printf '%s\nplain:\n%s\nstages fused:\n%s\ntextbook fused:\n%s\n' "$1" "$plain" "$stages" "$textbook" >&2; exit 1; }

[ -n "$right" ] || fail "no picture"
[ -z "$(grep -v " $right$" <<<"$plain")" ] || fail "without fusing, not all pictures are the same"
grep -q "^AVX2 " <<<"$stages" || fail "this processor cannot run AVX2: nothing is shown"
while read -r name sum; do
    case $name in
        AVX*) [ "$sum" != "$right" ] || fail "$name fused gives the same picture: the comparison proves nothing" ;;
        *) [ "$sum" = "$right" ] || fail "$name was not fused and gives another picture" ;;
    esac
done <<<"$stages"
[ "$(sed -n 's/^textbook //p' <<<"$textbook")" != "$right" ] || fail "the textbook path fused gives the same picture"
