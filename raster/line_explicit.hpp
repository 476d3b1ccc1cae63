// The line by its explicit equation, y = a x + B for each column x (textbook section 5.1, before the midpoint
// test). A foil for line_midpoint.hpp.
//
//     a = dy / dx,  B = y0 - a x0;  for every column: light (x, round(a x + B))
//
// What goes wrong, on purpose: a multiplication a pixel; a steep line has one pixel a column, so |a| > 1
// leaves gaps of |a| - 1 rows; and a vertical line has no such equation: a = dy / 0. There the answer is what
// the formula has to say: nothing, also for a single pixel (0 / 0); the event SlopeUndefined tells. a and B
// are floats: where |a x| is above 2^23, rows come out wrong by whole pixels.
//
// The columns run from the left end to the right one; a tie goes to the row that the line leaves. Columns
// outside the box cost nothing, rows outside are left out.
#pragma once
#include <cstdlib>

#include "raster/line_dda.hpp"

namespace relevo::raster {

struct ExplicitStarted {
    Pixel left, right;
    float a, b;  // y = a x + b
};

// dx = 0: the equation divides by zero, nothing is drawn.
struct SlopeUndefined {
    std::int64_t dy;
};

// A pixel in the box is lit.
struct ExplicitColumn {
    int x;
    float y;  // a x + B
    Pixel pixel;
};

// Calls plot(x, y) for each pixel in the box, from left to right.
template <class Plot, class Probe = const pipeline::NoProbe>
void line_explicit(Pixel a, Pixel b, const PixelBox& box, Plot&& plot, Probe&& probe = {}) {
    if (a.x > b.x) std::swap(a, b);
    const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
    if (dx == 0) return pipeline::note<SlopeUndefined>(probe, std::abs(dy));
    const float slope = static_cast<float>(dy) / static_cast<float>(dx);
    const float at_zero = static_cast<float>(a.y) - slope * static_cast<float>(a.x);
    pipeline::note<ExplicitStarted>(probe, a, b, slope, at_zero);
    const std::int64_t last = std::min(b.x, box.x1);
    for (std::int64_t x = std::max(a.x, box.x0); x <= last; ++x) {
        const float y = slope * static_cast<float>(x) + at_zero;
        const double row = nearest_across(y, slope);
        if (!(box.y0 <= row && row <= box.y1)) continue;
        const Pixel pixel{static_cast<std::int32_t>(x), static_cast<std::int32_t>(row)};
        pipeline::note<ExplicitColumn>(probe, static_cast<int>(x), y, pixel);
        plot(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
    }
}

}  // namespace relevo::raster
