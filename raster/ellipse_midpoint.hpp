// The midpoint ellipse: a quarter of it by additions of whole numbers, in two regions; the others mirrored.
//
// Source: textbook section 5.3 (with its increment of region 2 corrected), after Da Silva 1989 as told by
// Foley, van Dam, Feiner and Hughes 1990, section 3.4. The textbook's own algorithm: ellipse_textbook.hpp.
//
//   F(x, y) = b^2 x^2 + a^2 y^2 - a^2 b^2         negative inside
//
// Region 1, from (0, b) on, the curve flatter than the diagonal: E or SE by the sign of
//   d = F(x + 1, y - 1/2);   E: d += b^2 (2x + 3)         SE: d += b^2 (2x + 3) + a^2 (2 - 2y)
// Region 2, down to (a, 0), steeper: SE or S by the sign of
//   d = F(x + 1/2, y - 1);   SE: d += b^2 (2x + 2) + a^2 (3 - 2y)          S: d += a^2 (3 - 2y)
//
// d is a whole number and a quarter of a^2 or b^2; all increments are whole, so the fraction never matters
// and is dropped; 0 counts as positive. Where region 1 ends, and why: ellipse_arc.hpp. A flat ellipse comes
// down to y = 0 within region 1, long before x = a: from there the row y = 0 goes on to (a, 0).
//
// So every pixel is the nearest of its column (region 1) or row (region 2): within 1/2 pixel.
#pragma once
#include <cstdint>

#include "raster/circle_midpoint.hpp"
#include "raster/ellipse_arc.hpp"

namespace relevo::raster {

// Event: an algorithm begins. `region1_end` is the last column of region 1.
struct EllipseStarted {
    Pixel center;
    int a, b;
    int region1_end;
};

enum class EllipseChoice { E, SE, S };

// Event: a decision at pixel (x, y) of the quarter, d before it.
struct EllipseStep {
    int region;
    int x, y;
    std::int64_t d;
    EllipseChoice choice;
};

// Event: region 2 begins after pixel (x, y), and d is computed anew.
struct EllipseTurned {
    int x, y;
    std::int64_t d;
};

// |d| stays below 4 a b max(a, b) <= 2^62.
struct EllipseMidpoint {
    std::int64_t a2, b2, d;
    int x, y;

    static constexpr EllipseMidpoint region1(const EllipseArc& arc, std::int64_t x, std::int64_t y) {
        const std::int64_t a2 = arc.a * arc.a, b2 = arc.b * arc.b;
        const Int128 d = Int128{b2} * ((x + 1) * (x + 1)) + Int128{a2} * (y * y - y - b2) + a2 / 4;
        return {a2, b2, static_cast<std::int64_t>(d), static_cast<int>(x), static_cast<int>(y)};
    }
    template <class Probe>
    static constexpr EllipseMidpoint region2(const EllipseArc& arc, std::int64_t x, std::int64_t y,
                                             Probe& probe) {
        const std::int64_t a2 = arc.a * arc.a, b2 = arc.b * arc.b;
        const Int128 whole = Int128{b2} * (x * x + x) + Int128{a2} * ((y - 1) * (y - 1) - b2) + b2 / 4;
        const auto d = static_cast<std::int64_t>(whole);
        note<EllipseTurned>(probe, static_cast<int>(x), static_cast<int>(y), d);
        return {a2, b2, d, static_cast<int>(x), static_cast<int>(y)};
    }
    template <class Probe>
    constexpr void east_or_south_east(Probe& probe) {
        note<EllipseStep>(probe, 1, x, y, d, d < 0 ? EllipseChoice::E : EllipseChoice::SE);
        if (d < 0) {
            d += b2 * (2 * x + 3);
        } else {
            d += b2 * (2 * x + 3) + a2 * (2 - 2 * y);
            --y;
        }
        ++x;
    }
    template <class Probe>
    constexpr void south_or_south_east(Probe& probe) {
        note<EllipseStep>(probe, 2, x, y, d, d < 0 ? EllipseChoice::SE : EllipseChoice::S);
        if (d < 0) {
            d += b2 * (2 * x + 2) + a2 * (3 - 2 * y);
            ++x;
        } else {
            d += a2 * (3 - 2 * y);
        }
        --y;
    }
};

// What all ellipses share: a circle is drawn by `Circle`, a flat one as the line it is, the rest by `Steps`.
template <class Steps, class Circle, class Plot, class Probe>
constexpr bool draw_ellipse(Pixel center, int a, int b, const PixelBox& box, Plot&& plot, Probe& probe) {
    if (a == b) return clip_circle<Circle>(center, a, box, plot, probe);
    if (a > largest_ellipse_radius || b > largest_ellipse_radius) return false;
    if (a < 0 || b < 0) return true;
    const std::int64_t cx = center.x, cy = center.y;
    if (b == 0) {
        plot_row(cx - a, cx + a, cy, box, plot);
    } else if (a == 0) {
        plot_column(cx, cy - b, cy + b, box, plot);
    } else {
        const EllipseArc arc{a, b};
        if constexpr (pipeline::Wants<Probe, EllipseStarted>)
            note<EllipseStarted>(probe, center, a, b, static_cast<int>(arc.region1_end()));
        clip_ellipse<Steps>(center, arc, box, plot, probe);
    }
    return true;
}

// Calls plot(x, y) once for each pixel of the ellipse that lies in the box, in no order worth relying on. a
// is the horizontal radius, b the vertical one. a = b: the circle's algorithm and pixels. a = 0 or b = 0: a
// line. A negative radius draws nothing. Returns false, and draws nothing, for radii above 2^20 (2^30 when
// equal).
template <class Plot, class Probe = NoProbe>
constexpr bool ellipse_midpoint(Pixel center, int a, int b, const PixelBox& box, Plot&& plot,
                                Probe&& probe = NoProbe{}) {
    return draw_ellipse<EllipseMidpoint, CircleMidpoint>(center, a, b, box, plot, probe);
}

}  // namespace relevo::raster
