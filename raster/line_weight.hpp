// Lines of equal apparent thickness (Foley, van Dam, Feiner, Hughes 1990, section 3.2.3).
//
// An aliased line lights max(|dx|, |dy|) + 1 pixels, whatever its length sqrt(dx^2 + dy^2): at 45 degrees the
// same pixels have to do for a way sqrt 2 times as long, and the line looks thinner. Nothing can be brighter
// than full, so the others are dimmed until all have the light per length of the diagonal:
//
//     weight = sqrt(dx^2 + dy^2) / (sqrt 2 max(|dx|, |dy|))      1 for a diagonal, 0.707 along an axis
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "raster/pixel.hpp"

namespace relevo::raster {

// The coverage, in 1/65536 and rounded to the nearest, of every pixel of a line from a to b. 46341..65536; a
// single pixel is not a line and has full coverage.
inline int line_weight(Pixel a, Pixel b) {
    const auto span = [](std::int32_t from, std::int32_t to) {
        return static_cast<double>(std::abs(std::int64_t{to} - from));
    };
    const auto [minor, major] = std::minmax({span(a.x, b.x), span(a.y, b.y)});
    if (major == 0) return full_coverage;
    const double slope = minor / major;
    return static_cast<int>(std::floor(full_coverage * std::sqrt((1 + slope * slope) / 2) + 0.5));
}

}  // namespace relevo::raster
