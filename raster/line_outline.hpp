// A line of any width is a rectangle (textbook section 8.1, fig. 8.3): what area sampling covers.
//
//     along = (b - a) / length,  across = along turned by 90 degrees;  corners a, b +- width / 2 across
//
// Ends are butt: they stand upright on the line at a and at b, so the area is width * length and lines that
// follow one another add up. By the same rule a line without length has no area: all four corners are at a,
// and nothing is covered. So has a width that is not above 0. An end or a width that is not finite, or a line
// too long for a double: four times (0, 0), and nothing is covered.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

namespace relevo::raster {

// Length of a vector; no square of a large or small number overflows on the way.
inline double vector_length(double x, double y) {
    const double large = std::max(std::fabs(x), std::fabs(y)), small = std::min(std::fabs(x), std::fabs(y));
    if (!(large > 0)) return large;
    const double ratio = small / large;
    return large * std::sqrt(1 + ratio * ratio);
}

// The corners, clockwise on the page (y down); the first is to the right of a for one who walks to b.
inline std::array<glm::dvec2, 4> line_outline(glm::dvec2 a, glm::dvec2 b, double width) {
    const double dx = b.x - a.x, dy = b.y - a.y, length = vector_length(dx, dy);
    if (!std::isfinite(dx) || !std::isfinite(dy) || !std::isfinite(length) || !std::isfinite(width))
        return {};
    if (length == 0 || !(width > 0)) return {a, a, a, a};
    const glm::dvec2 across{-dy / length * (width / 2), dx / length * (width / 2)};
    return {a + across, a - across, b - across, b + across};
}

}  // namespace relevo::raster
