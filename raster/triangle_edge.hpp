// Triangle coverage by edge functions in exact integers, with the top-left rule (Pineda 1988;
// Direct3D 11.3 3.4.2.1).
//
// Corners lie on 1/256 pixel, so every edge value is an exact int64 below 2^49 and coverage needs no
// tolerance: a pixel belongs to the triangle when its centre lies inside, or on a top or left edge. A centre
// on an edge that two triangles share belongs to exactly one of them.
//
//   with corner 0 the one of smallest (Y, X) and corners 1, 2 in the order of positive area,
//   p = centre - corner 0:   E1 = p.x D2.y - p.y D2.x     E2 = D1.x p.y - D1.y p.x     E0 = area - E1 - E2
#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>

#include "pipeline/viewport.hpp"
#include "raster/pixel.hpp"

namespace relevo::raster {

using pipeline::BigWhole;
using pipeline::Scalar;
using pipeline::select;
using pipeline::SnappedCorner;
using pipeline::SnappedCornerOf;
using pipeline::to_big;
using pipeline::Whole;

// Twice the signed area in the y-down window, in 1/65536 pixel: negative when counter-clockwise as seen.
template <class Real>
constexpr BigWhole<Real> area2(const SnappedCornerOf<Real>& a, const SnappedCornerOf<Real>& b,
                               const SnappedCornerOf<Real>& c) {
    const BigWhole<Real> bx = to_big(b.x - a.x), by = to_big(b.y - a.y);
    const BigWhole<Real> cx = to_big(c.x - a.x), cy = to_big(c.y - a.y);
    return bx * cy - by * cx;
}

// Where the canonical corners 0, 1, 2 stand in the caller's order.
struct CornerOrder {
    int index[3];
};

// Corner 0 is the one with the smallest (Y, X); corners 1 and 2 give a positive area. All later formulas
// treat 1 and 2 alike, so neither the caller's first corner nor the winding changes a bit of the picture.
constexpr CornerOrder canonical_order(const SnappedCorner& a, const SnappedCorner& b, const SnappedCorner& c,
                                      bool positive_area) {
    const auto above = [](const SnappedCorner& p, const SnappedCorner& q) {
        return p.y < q.y || (p.y == q.y && p.x < q.x);
    };
    const int first = above(b, a) ? (above(c, b) ? 2 : 1) : (above(c, a) ? 2 : 0);
    const int next = first == 2 ? 0 : first + 1, last = first == 0 ? 2 : first - 1;
    return positive_area ? CornerOrder{{first, next, last}} : CornerOrder{{first, last, next}};
}

template <class Real>
struct TriangleOf {
    SnappedCornerOf<Real> corner[3];    // canonical order
    BigWhole<Real> area;                // twice the area, > 0
    BigWhole<Real> dx1, dy1, dx2, dy2;  // corner k - corner 0
    BigWhole<Real> bias[3];             // 0 for a top or left edge, else 1: covered means E - bias >= 0
};
using Triangle = TriangleOf<Scalar>;

// The edge opposite to a corner, with direction (dx, dy): it goes up (left) or to the right along a row
// (top).
template <class Number>
constexpr auto is_top_left(const Number& dx, const Number& dy) {
    return dy < 0 || (dy == 0 && dx > 0);
}

template <class Real>
constexpr TriangleOf<Real> make_triangle(const SnappedCornerOf<Real>& c0, const SnappedCornerOf<Real>& c1,
                                         const SnappedCornerOf<Real>& c2) {
    const auto bias = [](const Whole<Real>& dx, const Whole<Real>& dy) {
        return to_big(select(is_top_left(dx, dy), Whole<Real>(0), Whole<Real>(1)));
    };
    return {{c0, c1, c2},
            area2(c0, c1, c2),
            to_big(c1.x - c0.x),
            to_big(c1.y - c0.y),
            to_big(c2.x - c0.x),
            to_big(c2.y - c0.y),
            {bias(c2.x - c1.x, c2.y - c1.y), bias(c0.x - c2.x, c0.y - c2.y), bias(c1.x - c0.x, c1.y - c0.y)}};
}

template <class Real>
struct EdgeValuesOf {
    BigWhole<Real> e0, e1, e2;  // exact; their sum is the area
};
using EdgeValues = EdgeValuesOf<Scalar>;

constexpr EdgeValues edge_values(const Triangle& t, int x, int y) {
    const std::int64_t px = std::int64_t{x} * 256 + 128 - t.corner[0].x,
                       py = std::int64_t{y} * 256 + 128 - t.corner[0].y;
    const std::int64_t e1 = px * t.dy2 - py * t.dx2, e2 = t.dx1 * py - t.dy1 * px;
    return {t.area - e1 - e2, e1, e2};
}

constexpr bool is_covered(const Triangle& t, const EdgeValues& e) {
    return ((e.e0 - t.bias[0]) | (e.e1 - t.bias[1]) | (e.e2 - t.bias[2])) >= 0;
}

// The pixels whose centres can lie inside, cut to the picture.
constexpr PixelBox pixel_box(const SnappedCorner (&c)[3], int width, int height) {
    const auto [left, right] = std::minmax({c[0].x, c[1].x, c[2].x});
    const auto [top, bottom] = std::minmax({c[0].y, c[1].y, c[2].y});
    // the first centre at or after a: ceil((a - 128) / 256); the last one at or before b: floor((b - 128) /
    // 256)
    return {std::max((left + 127) >> 8, 0), std::max((top + 127) >> 8, 0),
            std::min((right - 128) >> 8, width - 1), std::min((bottom - 128) >> 8, height - 1)};
}

// The covered pixels of a row: a triangle is convex, so they are one span. `e` are the edge values at pixel
// box.x0. Along the row an edge value is E + k s, exactly, so E + k s >= bias solves to k >= ceil((bias - E)
// / s) or k <= floor((E - bias) / -s): three integer divisions a row, no test a pixel.
constexpr Span covered_span(const Triangle& t, const EdgeValues& e, const PixelBox& box) {
    const std::int64_t slope[3] = {256 * (t.dy1 - t.dy2), 256 * t.dy2, -256 * t.dy1};
    const std::int64_t value[3] = {e.e0 - t.bias[0], e.e1 - t.bias[1], e.e2 - t.bias[2]};
    std::int64_t first = 0, last = box.x1 - box.x0;
    for (int i = 0; i < 3; ++i) {
        if (slope[i] == 0 && value[i] < 0) return {box.x0, box.x0};
        if (slope[i] > 0 && value[i] < 0) first = std::max(first, (slope[i] - 1 - value[i]) / slope[i]);
        if (slope[i] < 0) last = value[i] < 0 ? -1 : std::min(last, value[i] / -slope[i]);
    }
    if (first > last) return {box.x0, box.x0};
    return {box.x0 + static_cast<int>(first), box.x0 + static_cast<int>(last) + 1};
}

// Calls visit(y, span, values at span.x0) for every row of the box that has covered pixels, from top to
// bottom.
template <class Visit>
constexpr void for_each_span(const Triangle& t, const PixelBox& box, Visit&& visit) {
    for (int y = box.y0; y <= box.y1; ++y) {
        const EdgeValues row = edge_values(t, box.x0, y);
        const Span span = covered_span(t, row, box);
        if (span.x0 < span.x1) visit(y, span, edge_values(t, span.x0, y));
    }
}

}  // namespace relevo::raster
