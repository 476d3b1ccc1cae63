// The line by a digital differential analyser: one addition of the slope a step, in floating point (Foley,
// van Dam, Feiner, Hughes 1990, section 3.2.1). A foil for line_midpoint.hpp.
//
//     y += slope;  light (x, round(y));  x += 1
//
// The walk and the rule for ties are those of line_midpoint, so in exact arithmetic the pixels would be the
// same. But the slope is rounded to 24 bits and every sum again, and the errors add up (measured over lines
// from the origin, tests/raster/line_dda_test.cpp):
//
//     length          10     100     1000     10,000   100,000
//     sum off by   0.000001  0.0001    0.012      1.1        42 pixels
//     differ           0     0.28 %    0.11 %     7 %      79 %  of the pixels (of short lines: ties)
//
// The last pixel need not be the line's end.
//
// In a box the sum starts anew at the first column (steep: row) of the box with y = y0 + step * slope: what
// lies before costs nothing. So a cut line can light other pixels than the uncut one. line_midpoint does not
// have this fault.
#pragma once
#include <cmath>

#include "pipeline/probe.hpp"
#include "raster/line_walk.hpp"

namespace relevo::raster {

struct DdaStarted {
    LineWalk walk;
    float slope;  // minor over major, -1..1
};

// A pixel in the box is lit.
struct DdaStep {
    std::int64_t step;
    float across;  // the sum: y of a flat line, x of a steep one
    Pixel pixel;
};

// The whole number nearest to `across`; a tie goes to the one that the line leaves.
inline float nearest_across(float across, float slope) {
    return slope > 0 ? std::ceil(across - 0.5f) : std::floor(across + 0.5f);
}

// Calls plot(x, y) for each pixel in the box, from the start of the walk to its end.
template <class Plot, class Probe = const pipeline::NoProbe>
void line_dda(Pixel a, Pixel b, const PixelBox& box, Plot&& plot, Probe&& probe = {}) {
    const LineWalk walk = line_walk(a, b);
    const std::int64_t start = walk.steep ? walk.from.y : walk.from.x;
    const std::int64_t first = std::max<std::int64_t>((walk.steep ? box.y0 : box.x0) - start, 0),
                       last = std::min((walk.steep ? box.y1 : box.x1) - start, walk.major);
    const float slope =
        walk.major == 0 ? 0.0f : static_cast<float>(walk.side * walk.minor) / static_cast<float>(walk.major);
    pipeline::note<DdaStarted>(probe, walk, slope);
    const double low = walk.steep ? box.x0 : box.y0, high = walk.steep ? box.x1 : box.y1;
    auto across = static_cast<float>(walk.steep ? walk.from.x : walk.from.y);
    if (first > 0) across += static_cast<float>(first) * slope;
    for (std::int64_t step = first; step <= last; ++step) {
        const double nearest = nearest_across(across, slope);
        if (low <= nearest && nearest <= high) {  // so it fits an int
            const int along = static_cast<int>(start + step), side = static_cast<int>(nearest);
            const Pixel pixel = walk.steep ? Pixel{side, along} : Pixel{along, side};
            pipeline::note<DdaStep>(probe, step, across, pixel);
            plot(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
        }
        across += slope;
    }
}

}  // namespace relevo::raster
