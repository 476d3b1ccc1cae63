// Line clipping by midpoint subdivision (Sproull and Sutherland 1968, "A clipping divider").
//
// Halve and look at outcodes, no division. 1. Look for a visible point: of a midpoint that is outside, at
// least one half is beyond a single side and can be dropped, since every bit of its code is also set in the
// code of one of the ends. 2. From a visible point, look for the last visible one towards each end: the half
// with both ends visible is kept, the other halved again.
//
// Midpoints are exact (a halved sum of doubles), so their codes are, too. Halving ends when the two points
// are the same in floats, or neighbours: after 280 halvings at most, whatever the floats. What halving cannot
// decide is left to cross_side: which of two neighbours is nearer to the end, and whether a segment that only
// touches the window at a corner does so. Coordinates that are not finite and windows with low > high are
// refused.
#pragma once
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "pipeline/clip_plane.hpp"

namespace relevo::pipeline {

enum class MidpointSearch { Visible, FirstVisible, LastVisible };

struct SegmentHalved {  // event
    MidpointSearch search;
    glm::vec2 from, middle, to;  // from: nearer to the segment's first end
    Outcode from_code, middle_code, to_code;
    bool keeps_first;  // the half from `from` to `middle` is searched on
};

struct ExactPlace {
    Exact x, y;
    Outcode code;
    glm::vec2 point;  // rounded
};

inline ExactPlace place_of(const Exact& x, const Exact& y, const ClipBox& box) {
    const auto order = [](const Exact& value, float limit) { return (value - Exact(limit)).sign(); };
    return {x,
            y,
            outcode_of(order(x, box.low.x), order(x, box.high.x), order(y, box.low.y), order(y, box.high.y)),
            {nearest_float(x, 1), nearest_float(y, 1)}};
}
inline ExactPlace middle_of(const ExactPlace& a, const ExactPlace& b, const ClipBox& box) {
    return place_of((a.x + b.x).half(), (a.y + b.y).half(), box);
}

// Equal, or no float lies between them.
inline bool are_neighbours(float a, float b) {
    const auto rank = [](float v) {  // counts the floats from zero
        const auto bits = std::bit_cast<std::int32_t>(v);
        return std::int64_t{bits < 0 ? INT32_MIN - std::int64_t{bits} : bits};
    };
    return std::abs(rank(a) - rank(b)) <= 1;
}
inline bool are_neighbours(const ExactPlace& a, const ExactPlace& b) {
    return are_neighbours(a.point.x, b.point.x) && are_neighbours(a.point.y, b.point.y);
}

// Where the segment crosses one of these sides within the window.
inline std::optional<glm::vec2> crossing_on_window(const Segment& segment, const ClipBox& box,
                                                   Outcode sides) {
    for (const Side side : {Side::Left, Side::Right, Side::Top, Side::Bottom})
        if (sides & outcode_of(side))
            if (const SideCrossing c = cross_side(segment, box, side); c.code == 0) return c.point;
    return std::nullopt;
}

template <class Probe = const NoProbe>
std::optional<Segment> clip_line_midpoint(const Segment& segment, const ClipBox& box, Probe&& probe = {}) {
    if (!is_finite(segment)) return note<ClipRefused>(probe, Refusal::NotFinite), std::nullopt;
    if (!is_window(box)) return note<ClipRefused>(probe, refusal_of(box)), std::nullopt;
    const auto halved = [&](MidpointSearch search, const ExactPlace& from, const ExactPlace& middle,
                            const ExactPlace& to, bool keeps_first) {
        note<SegmentHalved>(probe, search, from.point, middle.point, to.point, from.code, middle.code,
                            to.code, keeps_first);
    };
    ExactPlace from = place_of(segment.a.x, segment.a.y, box), to = place_of(segment.b.x, segment.b.y, box);
    ExactPlace visible = from.code == 0 ? from : to;
    while (visible.code != 0) {
        if (from.code & to.code) return std::nullopt;
        if (are_neighbours(from, to)) {
            const auto first = crossing_on_window(segment, box, from.code),
                       last = crossing_on_window(segment, box, to.code);
            if (!first || !last) return std::nullopt;
            return Segment{*first, *last};
        }
        visible = middle_of(from, to, box);
        const bool keeps_first = (visible.code & to.code) != 0;
        halved(MidpointSearch::Visible, from, visible, to, keeps_first);
        if (visible.code != 0) (keeps_first ? to : from) = visible;
    }
    // The end of the visible part between a visible and an outside place.
    const auto farthest = [&](ExactPlace outside, MidpointSearch search) {
        ExactPlace seen = visible;
        while (!are_neighbours(outside, seen)) {
            const ExactPlace middle = middle_of(outside, seen, box);
            const bool first = search == MidpointSearch::FirstVisible;
            halved(search, first ? outside : seen, middle, first ? seen : outside,
                   first == (middle.code == 0));
            (middle.code == 0 ? seen : outside) = middle;
        }
        return outside.point == seen.point ? seen.point : *crossing_on_window(segment, box, outside.code);
    };
    return Segment{from.code == 0 ? segment.a : farthest(from, MidpointSearch::FirstVisible),
                   to.code == 0 ? segment.b : farthest(to, MidpointSearch::LastVisible)};
}

}  // namespace relevo::pipeline
