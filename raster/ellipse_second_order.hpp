// The midpoint ellipse by second differences: no multiplication is left in its loops.
//
// Source: textbook section 5.3, its last paragraph.
//
// The increments of d in ellipse_midpoint.hpp grow evenly, each by its own constant:
//
//   region 1, E:  b^2 (2x + 3)     grows by 2 b^2 with x      region 2, SE: adds b^2 (2x + 2), 2 b^2 with x
//             SE: adds a^2 (2 - 2y), 2 a^2 with -y                      S:  a^2 (3 - 2y), 2 a^2 with -y
//
// So two running sums, one for x and one for y, are all that a step needs. The same d, the same pixels.
#pragma once
#include "raster/circle_second_order.hpp"
#include "raster/ellipse_midpoint.hpp"

namespace relevo::raster {

// Event: a decision at pixel (x, y): d and the parts of its increment that belong to x and y.
struct EllipseSecondOrderStep {
    int region;
    int x, y;
    std::int64_t d, along_x, along_y;
    EllipseChoice choice;
};

struct EllipseSecondOrder {
    std::int64_t twice_a2, twice_b2, d, along_x, along_y;
    int x, y;

    static constexpr EllipseSecondOrder region1(const EllipseArc& arc, std::int64_t x, std::int64_t y) {
        const EllipseMidpoint m = EllipseMidpoint::region1(arc, x, y);
        return {2 * m.a2, 2 * m.b2, m.d, m.b2 * (2 * x + 3), m.a2 * (2 - 2 * y), m.x, m.y};
    }
    template <class Probe>
    static constexpr EllipseSecondOrder region2(const EllipseArc& arc, std::int64_t x, std::int64_t y,
                                                Probe& probe) {
        const EllipseMidpoint m = EllipseMidpoint::region2(arc, x, y, probe);
        return {2 * m.a2, 2 * m.b2, m.d, m.b2 * (2 * x + 2), m.a2 * (3 - 2 * y), m.x, m.y};
    }
    template <class Probe>
    constexpr void east_or_south_east(Probe& probe) {
        note<EllipseSecondOrderStep>(probe, 1, x, y, d, along_x, along_y,
                                     d < 0 ? EllipseChoice::E : EllipseChoice::SE);
        if (d < 0) {
            d += along_x;
        } else {
            d += along_x + along_y;
            along_y += twice_a2;
            --y;
        }
        along_x += twice_b2;
        ++x;
    }
    template <class Probe>
    constexpr void south_or_south_east(Probe& probe) {
        note<EllipseSecondOrderStep>(probe, 2, x, y, d, along_x, along_y,
                                     d < 0 ? EllipseChoice::SE : EllipseChoice::S);
        if (d < 0) {
            d += along_x + along_y;
            along_x += twice_b2;
            ++x;
        } else {
            d += along_y;
        }
        along_y += twice_a2;
        --y;
    }
};

// As ellipse_midpoint().
template <class Plot, class Probe = NoProbe>
constexpr bool ellipse_second_order(Pixel center, int a, int b, const PixelBox& box, Plot&& plot,
                                    Probe&& probe = NoProbe{}) {
    return draw_ellipse<EllipseSecondOrder, CircleSecondOrder>(center, a, b, box, plot, probe);
}

}  // namespace relevo::raster
