#!/usr/bin/env bash
# Compiled code on the way to a pixel calls none of libm's rounded-at-will functions (sqrt, floor and their like are exact).
# It sees what the source hides: the calls that a template of GLM makes.
#   tests/support/no_libm.sh ARCHIVE_OR_OBJECT...
set -euo pipefail
bad=0
for file in "$@"; do
    calls=$(nm --undefined-only "$file" |
        grep -E ' U (a?(sin|cos|tan)h?|sincos|atan2|exp(2|10|m1)?|log(2|10|1p)?|pow|cbrt|hypot|fma)[fl]?(@.*)?$' || true)
    [ -z "$calls" ] || { echo "$file calls the math library:"; echo "$calls"; bad=1; }
done
exit "$bad"
