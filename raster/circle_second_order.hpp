// The midpoint circle by second differences: the increments of d are themselves updated by adding constants.
//
// Source: textbook section 5.2, its last paragraph; Foley, van Dam, Feiner and Hughes 1990, section 3.3.2.
//
// circle_midpoint.hpp computes its increments 2x + 3 and 2x - 2y + 5 anew from x and y. But they grow evenly:
// a step to E adds 2 to both; a step to SE adds 2 to the first and 4 to the second. So nothing is left to
// compute but three additions a pixel. The same d, the same pixels.
//
//               at (0, R)      after E    after SE
//   delta E     3              + 2        + 2
//   delta SE    5 - 2R         + 2        + 4
#pragma once
#include "raster/circle_midpoint.hpp"

namespace relevo::raster {

// Event: a decision at pixel (x, y), with d and both increments before it.
struct CircleSecondOrderStep {
    int x, y;
    int d, delta_east, delta_south_east;
    bool east;
};

struct CircleSecondOrder {
    int x, y, d, delta_east, delta_south_east;

    static constexpr CircleSecondOrder at(int x, int y, int radius) {
        return {x, y, CircleMidpoint::at(x, y, radius).d, 2 * x + 3, 2 * (x - y) + 5};
    }
    template <class Probe>
    constexpr void step(Probe& probe) {
        note<CircleSecondOrderStep>(probe, x, y, d, delta_east, delta_south_east, d < 0);
        if (d < 0) {
            d += delta_east;
            delta_south_east += 2;
        } else {
            d += delta_south_east;
            delta_south_east += 4;
            --y;
        }
        delta_east += 2;
        ++x;
    }
};

// As circle_midpoint().
template <class Plot, class Probe = NoProbe>
constexpr bool circle_second_order(Pixel center, int radius, const PixelBox& box, Plot&& plot,
                                   Probe&& probe = NoProbe{}) {
    return clip_circle<CircleSecondOrder>(center, radius, box, plot, probe);
}

}  // namespace relevo::raster
