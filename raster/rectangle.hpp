// An upright rectangle: half-open rows and columns, as in fig. 5.8.
//
// Source: textbook section 5.4, figure 5.8. The figure's y grows upwards and its rectangle is open to the
// right and above; our rows grow downwards.
//
// A centre on the left side belongs to the rectangle, one on the right side to the neighbour there. Of the
// two level sides one is closed:
//   FillRule::TopLeft  the upper one, as triangle_edge.hpp has it
//   FillRule::Book     the lower one, as fig. 5.8 has it
// So rectangles that share a side share no pixel and leave none out, and so do four that share a corner.
//
// Any two opposite corners. A rectangle without width or height covers nothing. All int32 coordinates are
// right.
#pragma once
#include <algorithm>
#include <cstdint>

#include "pipeline/probe.hpp"
#include "raster/pixel.hpp"
#include "raster/shape.hpp"

namespace relevo::raster {

// The pixels of the rectangle, before the box cuts them: x0..x1 by y0..y1, empty when there are none.
struct RectangleBounded {
    SnappedPoint upper_left, lower_right;
    PixelBox pixels;
};

// Calls span(y, x0, x1) for each row with pixels x0 <= x < x1, from top to bottom.
template <class SpanSink, class Probe = pipeline::NoProbe>
constexpr void rectangle(const SnappedPoint& a, const SnappedPoint& b, FillRule rule, const PixelBox& box,
                         SpanSink&& span, Probe&& probe = {}) {
    const auto [left, right] = std::minmax({a.x, b.x});
    const auto [top, bottom] = std::minmax({a.y, b.y});
    // first centre at or after v: ceil((v - 128) / 256); first centre after v: floor((v - 128) / 256) + 1
    const auto from = [](std::int64_t v) { return static_cast<int>((v + 127) >> 8); };
    const auto after = [](std::int64_t v) { return static_cast<int>((v + 128) >> 8); };
    const bool own_top = rule == FillRule::TopLeft;
    const PixelBox all{from(left), own_top ? from(top) : after(top), from(right) - 1,
                       (own_top ? from(bottom) : after(bottom)) - 1};
    pipeline::note<RectangleBounded>(probe, SnappedPoint{left, top}, SnappedPoint{right, bottom}, all);
    const PixelBox seen{std::max(all.x0, box.x0), std::max(all.y0, box.y0), std::min(all.x1, box.x1),
                        std::min(all.y1, box.y1)};
    if (seen.x0 > seen.x1) return;
    for (int y = seen.y0; y <= seen.y1; ++y) span(y, seen.x0, seen.x1 + 1);
}

}  // namespace relevo::raster
