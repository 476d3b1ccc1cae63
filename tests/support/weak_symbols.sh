#!/usr/bin/env bash
# Code that is compiled for one instruction set must not leave its file: a weak function of which the linker keeps one
# copy for the whole program could be the AVX-512 one, and the program would end on a processor without it. In the
# stages' object files every weak function therefore carries the name of its instruction set.
#   tests/support/weak_symbols.sh ARCHIVE_OR_OBJECT...
set -euo pipefail
bad=0
seen=0
for file in "$@"; do
    while read -r member symbol; do
        seen=$((seen + 1))
        [[ $symbol == "" || $symbol =~ N_(SSE4|AVX2|AVX3) ]] && continue
        echo "$member: $(c++filt "$symbol")"
        bad=1
    done < <(nm --defined-only --print-file-name "$file" |
        sed -nE 's/^.*(stages_[a-z0-9]+)\.[^ ]*:[0-9a-f]* ([^ ]) ([^ ]+)$/\1 \2 \3/p' |
        awk '$2 == "W" { print $1, $3; next } { print $1 }' | sort -u)
done
((bad == 0)) || echo "  ^ weak functions that another instruction set may get: inline them by force, or give them its namespace" >&2
((seen > 0)) || { echo "weak_symbols: no object of stages_* in $*" >&2; exit 1; }
exit "$bad"
