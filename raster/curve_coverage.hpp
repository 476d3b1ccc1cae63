// Discs and rings with smooth edges: of every pixel's square, the area that the ellipse covers.
//
// Source: unweighted area sampling, textbook section 8.1 (Catmull 1978, "A hidden-surface algorithm with
// anti-aliasing"); here the edge is the curve itself, not a polygon.
//
// In a row of pixels, S(u) is the area between the vertical through the centre and the vertical at u; S is
// odd. A pixel from u to u + 1 is covered by S(u + 1) - S(u): thin ellipses, both edges in one pixel, and
// holes need no thought of their own. S is a sum of strips of the curve's half width X(v):
//
//   S(u) = integral of min(X(v), u) dv over the row = u (V - v0) + integral of X from V to v1,   X(V) = u
//
// and the integral is the trapezium under the chord, and the segment between chord and arc. Stretched to a
// unit circle, the segment over an angle t is (t - sin t) / 2; sin t is the cross product of its ends, and
// t = asin(sin t) a polynomial. So all is +, -, *, / and sqrt. Only the pixels that the edge touches cost it;
// those between come as one run. S is rounded, not the difference: the error of a row does not grow.
//
// A ring of width w is the disc of radii a + w/2, b + w/2 without the disc of a - w/2, b - w/2. For a circle
// that is what a pen of width w draws. For an ellipse the pen's outline is no ellipse: ours is as wide as the
// pen on the axes, and thinner between, at the thinnest by the factor 2 sqrt(a b) / (a + b): 0.94 for 2 : 1.
//
// Errors: 2^-15 of a pixel for each pixel with radii up to 2^24, 2^-9 at 2^30; 2^-15 a row for the sum. Where
// a row holds more than 45 degrees of the arc (ellipses a few pixels high) 2^-27 a b more for a pixel, and
// 2^-22 a b for the sum: too little to be seen below a b = 2^12.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

#include "pipeline/probe.hpp"
#include "raster/pixel.hpp"

namespace relevo::raster {

using pipeline::NoProbe;
using pipeline::note;

inline constexpr double largest_curve = 0x1p30;    // radii and centres
inline constexpr double smallest_curve = 0x1p-20;  // no pixel of a thinner one reaches half a 65536th

// Event: a row of a disc, or of the outer and inner edge of a ring. Half widths at the centre's height or as
// near to it as the row comes, and as far as it goes; `area`: of half the disc in this row, in pixels.
struct CurveRow {
    int y;
    bool inner;
    double widest, narrowest, area;
};

// (asin(s) - s) / (2 s^3) as a function of s^2 <= 1/2, within 1.9e-7 (9e-9 for s^2 <= 1/20): Chebyshev
// interpolation of its difference from 1/12.
inline double arc_series(double z) {
    const double z2 = z * z;
    return 1.0 / 12 + z * ((0.0374997882503 + 0.0223517365632 * z) +
                           z2 * ((0.0145058231875 + 0.0166623867797 * z) +
                                 z2 * (-0.00998987296019 + 0.0324442183135 * z)));
}

// The part of a row on one side of the horizontal axis: distances near <= far from it.
struct CurveStrip {
    double near = 0, far = 0;
    double widest = 0, narrowest = 0;  // X(near), X(far)
    double area = 0;                   // integral of X
};

// An ellipse around (0, 0) with radii a, b > 0.
struct CurveShape {
    double a, b;
    double a_by_b = a / b, b_by_a = b / a, area_scale = a * b, unit = 1 / (a * b);

    double half_width(double v) const { return a_by_b * std::sqrt(std::max((b - v) * (b + v), 0.0)); }
    double half_height(double u) const { return b_by_a * std::sqrt(std::max((a - u) * (a + u), 0.0)); }
    // The integral of X(v) over a piece of the arc of at most a quarter, its ends given. On the unit circle
    // the piece has the angle t, sin(t) is the cross product of its ends, and the segment is (t - sin(t))
    // / 2.
    double under_arc(double wide, double narrow, double near, double far) const {
        const double sine = (wide * far - narrow * near) * unit, sine2 = sine * sine;
        const double trapezium = 0.5 * (wide + narrow) * (far - near);
        if (sine2 <= 0.5) return trapezium + area_scale * (sine * sine2 * arc_series(sine2));
        const double du = (wide - narrow) / (2 * a), dv = (far - near) / (2 * b);  // half the chord
        const double s2 = std::min(du * du + dv * dv, 0.5), s = std::sqrt(s2);
        return trapezium + area_scale * (s + 2 * s * s2 * arc_series(s2) - 0.5 * sine);
    }
    CurveStrip strip(double near, double far, double widest, double narrowest) const {
        return {near, far, widest, narrowest, under_arc(widest, narrowest, near, far)};
    }
    // The area of the strip between the axis and the vertical at u, which cuts the arc.
    double area_at_arc(const CurveStrip& s, double u) const {
        const double v = std::min(std::max(half_height(u), s.near), s.far);
        return u * (v - s.near) + under_arc(u, s.narrowest, v, s.far);
    }
    // The same for any u >= 0.
    double area_before(const CurveStrip& s, double u) const {
        if (u <= s.narrowest) return u * (s.far - s.near);
        if (u >= s.widest) return s.area;
        return area_at_arc(s, u);
    }
};

inline std::int64_t in_65536ths(double area) {  // >= 0
    return static_cast<std::int64_t>(full_coverage * area + 0.5);
}

// One row of a shape. Where the row holds the horizontal axis it has two strips.
struct CurveSlice {
    bool touched = false, two = false;
    CurveStrip first, second;
    double widest = 0, narrowest = 0;

    // Rows of height 1 are asked for from top to bottom; `v0` and `v1` bound the row, v down from the centre.
    // `width_before` carries X(v1) to the next row.
    static CurveSlice of(const CurveShape& shape, double v0, double v1, double& width_before) {
        CurveSlice slice;
        if (v1 <= -shape.b || v0 >= shape.b) return slice;
        slice.touched = true;
        const double top = v0 > -shape.b ? v0 : -shape.b, bottom = v1 < shape.b ? v1 : shape.b;
        const double width_top = width_before;
        const double width_bottom = width_before = shape.half_width(bottom);
        if (bottom <= 0) {
            slice.first = shape.strip(-bottom, -top, width_bottom, width_top);
        } else if (top >= 0) {
            slice.first = shape.strip(top, bottom, width_top, width_bottom);
        } else {
            slice.two = true;
            slice.first = shape.strip(0, -top, shape.a, width_top);
            slice.second = shape.strip(0, bottom, shape.a, width_bottom);
        }
        slice.widest = slice.first.widest;
        slice.narrowest = std::min(width_top, width_bottom);
        return slice;
    }
    double area() const { return two ? first.area + second.area : first.area; }
    // One strip, and the centre's pixel lies inside of it: the left and the right edge keep apart.
    bool is_plain() const { return !two && narrowest >= 1; }
    // S(u) for u >= 0, in 1/65536 pixel.
    std::int64_t sum(const CurveShape& shape, double u) const {
        double area = shape.area_before(first, u);
        if (two) area += shape.area_before(second, u);
        return in_65536ths(area);
    }
};

// The last whole number <= x, cut to low..high; x may be anything but NaN.
inline int floor_between(double x, int low, int high) {
    if (!(x > low)) return low;
    if (!(x < high)) return high;
    const int i = static_cast<int>(x);
    return i - (i > x);
}

// The pixels of a row where the edges are (one by one), and those between (many alike).
struct CurvePieces {
    struct Piece {
        int x0, x1;
        bool run;
    } piece[6];
    int count = 0;
    void edge(int x0, int x1) { piece[count++] = {x0, x1, false}; }
    void run(int x0, int x1) {
        if (x0 <= x1) piece[count++] = {x0, x1, true};
    }
    // Two edges, and what is between.
    void edges(int x0, int x1, int x2, int x3) {
        if (x1 + 1 >= x2) return edge(x0, x3);
        edge(x0, x1), run(x1 + 1, x2 - 1), edge(x2, x3);
    }
};

// Calls cover(x, coverage) for the pixels of one edge of a plain row, from the outside in: pixel `x` holds
// the outermost point, `step` leads to the centre. Returns the first pixel that is covered all.
template <class Cover>
int cover_edge(double center, const CurveShape& shape, const CurveStrip& strip, int x, int step,
               Cover&& cover) {
    const double height = strip.far - strip.near, half = 0.5 * step;
    std::int64_t before = in_65536ths(strip.area);
    for (;; x += step) {
        const double u = step * (center - (x + half));  // from the centre to the inner side of the pixel
        const bool last = u <= strip.narrowest;
        const std::int64_t after = in_65536ths(last ? u * height : shape.area_at_arc(strip, u));
        cover(x, static_cast<int>(before - after));
        if (last) return x + step;
        before = after;
    }
}

// The same for a ring: `inner` is the strip of the hole. Returns the first pixel that is all hole.
template <class Cover, class Run>
int cover_edge(double center, const CurveShape& outer_shape, const CurveStrip& outer,
               const CurveShape& inner_shape, const CurveStrip& inner, int x, int step, Cover&& cover,
               Run&& run) {
    const double height = outer.far - outer.near, half = 0.5 * step;
    const std::int64_t hole = in_65536ths(inner.area);
    std::int64_t before = in_65536ths(outer.area) - hole;
    for (;; x += step) {
        const double u = step * (center - (x + half));
        if (u <= inner.narrowest) {
            cover(x, static_cast<int>(before));
            return x + step;
        }
        const bool straight = u <= outer.narrowest, whole = u >= inner.widest;
        const std::int64_t after = in_65536ths(straight ? u * height : outer_shape.area_at_arc(outer, u)) -
                                   (whole ? hole : in_65536ths(inner_shape.area_at_arc(inner, u)));
        cover(x, static_cast<int>(before - after));
        before = after;
        const int full = straight && whole ? static_cast<int>(u - inner.widest) : 0;
        if (full > 0) {
            run(x + step, x + step * full);
            x += step * full;
            const double v = step * (center - (x + half));
            before = in_65536ths(v * height) - hole;
        }
    }
}

// The rows of a shape, with a hole or without.
template <bool has_hole, class Cover, class Probe>
void cover_curve(glm::dvec2 center, const CurveShape& outer, const CurveShape& inner,
                 const PixelBox& whole_box, Cover&& cover, Probe& probe) {
    constexpr int end = 2147483645;  // the neighbours of the box are numbers, too
    const PixelBox box{std::max(whole_box.x0, -end), std::max(whole_box.y0, -end),
                       std::min(whole_box.x1, end), std::min(whole_box.y1, end)};
    const int first_row = floor_between(center.y - outer.b + 0.5, box.y0, box.y1);
    const int last_row = floor_between(center.y + outer.b + 0.5, box.y0, box.y1);
    const double first_edge = first_row - 0.5 - center.y;
    double outer_width = outer.half_width(std::clamp(first_edge, -outer.b, outer.b)), inner_width = 0;
    if (has_hole) inner_width = inner.half_width(std::clamp(first_edge, -inner.b, inner.b));

    for (int y = first_row; y <= last_row; ++y) {
        const double v0 = y - 0.5 - center.y, v1 = y + 0.5 - center.y;
        const CurveSlice out = CurveSlice::of(outer, v0, v1, outer_width);
        if (!out.touched) continue;
        CurveSlice in;
        if (has_hole) in = CurveSlice::of(inner, v0, v1, inner_width);
        note<CurveRow>(probe, y, false, out.widest, out.narrowest, out.area());
        if (in.touched) note<CurveRow>(probe, y, true, in.widest, in.narrowest, in.area());

        const auto pixel = [&](double u) {
            return floor_between(u + center.x + 0.5, box.x0 - 1, box.x1 + 1);
        };
        const auto one = [&](int x, int coverage) {
            if (coverage > 0) cover(y, x, x + 1, coverage < full_coverage ? coverage : full_coverage);
        };
        const auto run = [&](int x0, int x1) {
            x0 = std::max(x0, box.x0), x1 = std::min(x1, box.x1);
            if (x0 <= x1) cover(y, x0, x1 + 1, full_coverage);
        };
        const int left0 = pixel(-out.widest), right1 = pixel(out.widest);

        // Most rows: all in the box, left and right edge apart.
        if (left0 >= box.x0 && right1 <= box.x1 && out.is_plain()) {
            if (!in.touched) {
                const int x0 = cover_edge(center.x, outer, out.first, left0, 1, one);
                const int x1 = cover_edge(center.x, outer, out.first, right1, -1, one);
                run(x0, x1);
                continue;
            }
            if (has_hole && in.is_plain()) {
                const auto either = [&](int x0, int x1) { run(std::min(x0, x1), std::max(x0, x1)); };
                cover_edge(center.x, outer, out.first, inner, in.first, left0, 1, one, either);
                cover_edge(center.x, outer, out.first, inner, in.first, right1, -1, one, either);
                continue;
            }
        }
        // The others: first which pixels hold an edge.
        CurvePieces pieces;
        const int left1 = pixel(-out.narrowest), right0 = pixel(out.narrowest);
        if (!in.touched) {
            pieces.edges(left0, left1, right0, right1);
        } else {
            const int hole_left1 = pixel(-in.narrowest), hole_right0 = pixel(in.narrowest);
            if (hole_left1 + 1 >= hole_right0) {
                pieces.edge(left0, right1);
            } else {
                pieces.edges(left0, left1, pixel(-in.widest), hole_left1);
                pieces.edges(hole_right0, pixel(in.widest), right0, right1);
            }
        }
        const auto sum = [&](double u) {
            const double distance = std::abs(u);
            std::int64_t s = out.sum(outer, distance);
            if (in.touched) s -= in.sum(inner, distance);
            return u < 0 ? -s : s;
        };
        for (int i = 0; i < pieces.count; ++i) {
            const int x0 = std::max(pieces.piece[i].x0, box.x0), x1 = std::min(pieces.piece[i].x1, box.x1);
            if (pieces.piece[i].run) {
                run(x0, x1);
                continue;
            }
            if (x0 > x1) continue;
            std::int64_t before = sum(x0 - 0.5 - center.x);
            for (int x = x0; x <= x1; ++x) {
                const std::int64_t after = sum(x + 0.5 - center.x);
                one(x, static_cast<int>(after - before));
                before = after;
            }
        }
    }
}

// NaN and infinity are refused, and so is what is larger than 2^30.
inline bool can_cover(glm::dvec2 center, double a, double b) {
    return std::abs(center.x) <= largest_curve && std::abs(center.y) <= largest_curve && a <= largest_curve &&
           b <= largest_curve;
}

// Calls cover(y, x0, x1, coverage) for the pixels in the box that the disc covers, rows from top to bottom,
// pixels x0 <= x < x1, coverage 1..65536. A radius of 0 or less covers nothing. Returns false, and draws
// nothing, when the numbers are not finite or above 2^30.
template <class Cover, class Probe = NoProbe>
bool disc_coverage(glm::dvec2 center, double a, double b, const PixelBox& box, Cover&& cover,
                   Probe&& probe = NoProbe{}) {
    if (!can_cover(center, a, b)) return false;
    if (a > smallest_curve && b > smallest_curve && !box.empty())
        cover_curve<false>(center, {a, b}, {a, b}, box, cover, probe);
    return true;
}

// The same for the outline of the ellipse with radii a, b, drawn `width` wide. A radius below width/2 leaves
// no hole; radii of 0 make a dot. A negative radius, and a width of 0 or less, draw nothing.
template <class Cover, class Probe = NoProbe>
bool ring_coverage(glm::dvec2 center, double a, double b, double width, const PixelBox& box, Cover&& cover,
                   Probe&& probe = NoProbe{}) {
    const double half = width / 2;
    if (!(a >= 0 && b >= 0 && half > 0)) return !std::isnan(a + b + width);
    if (!can_cover(center, a + half, b + half)) return false;
    if (box.empty() || half < smallest_curve) return true;
    const CurveShape outer{a + half, b + half};
    if (a - half > smallest_curve && b - half > smallest_curve) {
        const CurveShape inner{a - half, b - half};
        cover_curve<true>(center, outer, inner, box, cover, probe);
    } else {
        cover_curve<false>(center, outer, outer, box, cover, probe);
    }
    return true;
}

}  // namespace relevo::raster
