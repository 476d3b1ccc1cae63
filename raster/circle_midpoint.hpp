// The midpoint circle: one octant by additions of whole numbers, the other seven mirrored.
//
// Source: textbook section 5.2; Bresenham 1977, "A linear algorithm for incremental digital display of
// circular arcs".
//
// In the octant from (0, R) to the diagonal the next pixel is E (x + 1, y) or SE (x + 1, y - 1). The circle
// passes closer to E when the midpoint M (x + 1, y - 1/2) between the two lies inside it:
//
//   d = F(M) = (x + 1)^2 + (y - 1/2)^2 - R^2 < 0      E:  d += 2x + 3      SE:  d += 2x - 2y + 5
//
// d starts as 5/4 - R and its steps are whole, so the 1/4 never matters: it is dropped, d starts as 1 - R,
// and 0 (which stands for 1/4) counts as positive. No midpoint ever lies on the circle, so there are no ties.
// Every pixel is the one of its column that is nearest to the circle, and the least |x^2 + y^2 - R^2| too.
#pragma once
#include <cstdint>

#include "raster/clip_circle.hpp"

namespace relevo::raster {

// Event: a decision at pixel (x, y) of the octant, d before it; `east` is the choice. In the picture the
// centre is added, and the other octants are mirrored.
struct CircleStep {
    int x, y;
    int d;
    bool east;
};

// |d| stays below 2 R + 3: 32 bits are enough up to R = 2^30.
struct CircleMidpoint {
    int x, y, d;

    static constexpr CircleMidpoint at(int x, int y, int radius) {
        const std::int64_t X = x, Y = y, R = radius;
        return {x, y, static_cast<int>((X + 1) * (X + 1) + Y * Y - Y - R * R)};
    }
    template <class Probe>
    constexpr void step(Probe& probe) {
        const bool east = d < 0;
        note<CircleStep>(probe, x, y, d, east);
        d += 2 * x + 3 + (east ? 0 : 2 - 2 * y);
        y -= east ? 0 : 1;
        ++x;
    }
};

// Calls plot(x, y) once for each pixel of the circle that lies in the box, in no order worth relying on.
// Radius 0 is one pixel, a negative one nothing; any centre. Returns false, and draws nothing, for a radius
// above 2^30.
template <class Plot, class Probe = NoProbe>
constexpr bool circle_midpoint(Pixel center, int radius, const PixelBox& box, Plot&& plot,
                               Probe&& probe = NoProbe{}) {
    return clip_circle<CircleMidpoint>(center, radius, box, plot, probe);
}

}  // namespace relevo::raster
