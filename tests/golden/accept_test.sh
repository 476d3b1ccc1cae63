#!/usr/bin/env bash
# Goldens are accepted one by one, with a reason, by people: golden_accept on a copy of the folder.   accept_test.sh PROGRAM
set -euo pipefail
accept=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
cp -r "$here"/*/ "$copy"
unset CI

sum() { (cd "$copy" && find . -type f -print0 | sort -z | xargs -0 sha256sum); }
refused() {  # WHAT_IT_SAYS WORDS...: exit 2, one line, no file changed
    local says=$1 before said status=0
    shift
    before=$(sum)
    said=$("$accept" "$copy" "$@" 2>&1) || status=$?
    [ "$status" = 2 ] && [[ $said == *"$says"* ]] && [ "$(wc -l <<<"$said")" = 1 ] && [ "$(sum)" = "$before" ] ||
        { echo "accept $*: status $status, said: $said" >&2; exit 1; }
}

refused 'which one?' --reason why
refused 'why?' coverage/fan
refused 'why?' coverage/fan --reason ' '
refused 'needs a text' coverage/fan --reason
refused 'no option' --all --reason why
refused 'no such golden' coverage/none --reason why
refused 'nothing to accept' coverage/fan --reason why
CI=1 refused 'CI does not accept' coverage/fan --reason why

# Two that fail: only the named one is accepted, and nothing of a list with a wrong name.
cp "$copy/coverage/cubes.png" "$copy/coverage/fan.png"
cp "$copy/window/ties.txt" "$copy/window/cubes.txt"
refused 'no such golden' coverage/fan coverage/none --reason why
"$accept" "$copy" coverage/fan --reason 'it "has" changed' >"$copy/said"
grep -q '48 expected' "$copy/said" || grep -q 'values differ' "$copy/said"
grep -qF 'reason = ' "$copy/coverage/fan.toml"
grep -q 'it .*has.* changed' "$copy/coverage/fan.toml"
cmp "$copy/coverage/fan.png" "$here/coverage/fan.png"
cmp "$copy/window/cubes.txt" "$copy/window/ties.txt"
rm "$copy/said"
refused 'nothing to accept' coverage/fan --reason why

# A golden that would let a known mistake pass is none.
sed -i 's/^mistakes = \[/mistakes = ["no culling",/' "$copy/window/ties.toml"
refused "would not notice 'no culling'" window/ties --reason why
sed -i 's/^mistakes = \[/mistakes = ["no such mistake",/' "$copy/coverage/fan.toml"
refused "would not notice 'no such mistake'" coverage/fan --reason why
