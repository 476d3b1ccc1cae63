// Line clipping with outcodes (Cohen and Sutherland 1968; textbook section 4.1.1, figures 4.2 and 4.3).
//
// Each end has a code with a bit for every side of the window that it lies beyond. Both codes 0: all is
// visible. A common bit: all is beyond that side, invisible. Otherwise an end with a bit set moves to the
// crossing with that side, and what it leaves behind is thrown away; repeat. Only sides whose bit is set are
// crossed, so the crossing always lies on the segment; but it can lie outside of the window still, and then
// the work was wasted: the order in which bits are looked at decides how often.
//
// The crossing lies on the side, so its bit is 0 by definition: were it computed from the rounded point, it
// could be set for ever, the endless loop of which the textbook warns. Every crossing is one of the given
// segment and its code is that of the exact place, so the decision is exact and each side is crossed once at
// most: four crossings, five rounds. Coordinates that are not finite and windows with low > high are refused.
#pragma once
#include <array>
#include <optional>

#include "pipeline/clip_plane.hpp"

namespace relevo::pipeline {

using SideOrder = std::array<Side, 4>;
inline constexpr SideOrder order_of_the_bits{Side::Top, Side::Bottom, Side::Right, Side::Left};

struct OutcodesCompared {  // event: one round
    Segment now;           // what is left of the segment
    Outcode a, b;
    bool accepted() const { return (a | b) == 0; }
    bool rejected() const { return (a & b) != 0; }
};
struct SideCrossed {  // event: an end moves
    Side side;
    bool moves_a;  // or b
    glm::vec2 from, to;
    Outcode before, after;
    bool wasted() const { return after != 0; }  // it will move again, or all is rejected
};

template <class Probe = const NoProbe>
std::optional<Segment> clip_line_cohen_sutherland(const Segment& segment, const ClipBox& box,
                                                  const SideOrder& order = order_of_the_bits,
                                                  Probe&& probe = {}) {
    if (!is_finite(segment)) return note<ClipRefused>(probe, Refusal::NotFinite), std::nullopt;
    if (!is_window(box)) return note<ClipRefused>(probe, refusal_of(box)), std::nullopt;
    SideCrossing a{segment.a, outcode(box, segment.a)}, b{segment.b, outcode(box, segment.b)};
    for (;;) {
        note<OutcodesCompared>(probe, Segment{a.point, b.point}, a.code, b.code);
        if ((a.code | b.code) == 0) return Segment{a.point, b.point};
        if ((a.code & b.code) != 0) return std::nullopt;
        SideCrossing& outside = a.code != 0 ? a : b;
        std::size_t next = 0;
        while ((outside.code & outcode_of(order[next])) == 0) ++next;
        const SideCrossing crossing = cross_side(segment, box, order[next]);
        note<SideCrossed>(probe, order[next], &outside == &a, outside.point, crossing.point, outside.code,
                          crossing.code);
        outside = crossing;
    }
}

}  // namespace relevo::pipeline
