// Parametric line clipping against a box (Liang and Barsky 1984; textbook section 4.1.2, table 4.1).
//
// The segment is P(t) = P0 + (P1 - P0) t, 0 <= t <= 1. It crosses the sides at
//
//   left (xmin - x0) / (x1 - x0)          right  (x0 - xmax) / (x0 - x1)
//   top  (ymin - y0) / (y1 - y0)          bottom (y0 - ymax) / (y0 - y1)        (y down)
//
// A positive denominator means that the segment enters the half-plane of the side there, a negative one that
// it leaves; 0: it is parallel, and outside when the numerator is positive. It is visible from the last
// entering t to the first leaving one. Values of t are compared as fractions, exactly; only the two ends that
// remain become points. Coordinates that are not finite and windows with low > high are refused.
#pragma once
#include <optional>

#include "pipeline/clip_plane.hpp"

namespace relevo::pipeline {

struct BoxParameterFound {  // event: one side of table 4.1. Numbers are rounded for show.
    Side side;
    double numerator, denominator;
    double t;  // not a number when parallel
    Passage passage;
    double t_in, t_out;  // after it
    bool empty;          // nothing is left: the segment is rejected here
};

// t = (a - b) / (c - d).
struct BoxParameter {
    float a, b, c, d;
    double numerator() const { return double{a} - double{b}; }
    double denominator() const { return double{c} - double{d}; }
    double value() const { return c == d ? NAN : numerator() / denominator(); }
};

// The sign of s - t; denominators are not 0.
inline int compared(const BoxParameter& s, const BoxParameter& t) {
    const int sign = (s.c > s.d ? 1 : -1) * (t.c > t.d ? 1 : -1);
    return sign * sign_of([&](auto n) {
               return (n(s.a) - n(s.b)) * (n(t.c) - n(t.d)) - (n(t.a) - n(t.b)) * (n(s.c) - n(s.d));
           });
}

// Table 4.1.
inline BoxParameter box_parameter(const Segment& s, const ClipBox& box, Side side) {
    switch (side) {
        case Side::Left:
            return {box.low.x, s.a.x, s.b.x, s.a.x};
        case Side::Right:
            return {s.a.x, box.high.x, s.a.x, s.b.x};
        case Side::Top:
            return {box.low.y, s.a.y, s.b.y, s.a.y};
        default:
            return {s.a.y, box.high.y, s.a.y, s.b.y};
    }
}

template <class Probe = const NoProbe>
std::optional<Segment> clip_line_liang_barsky(const Segment& segment, const ClipBox& box,
                                              Probe&& probe = {}) {
    if (!is_finite(segment)) return note<ClipRefused>(probe, Refusal::NotFinite), std::nullopt;
    if (!is_window(box)) return note<ClipRefused>(probe, refusal_of(box)), std::nullopt;
    BoxParameter in{0, 0, 1, 0}, out{1, 0, 1, 0};
    std::optional<Side> in_side, out_side;  // none: the given end
    for (const Side side : {Side::Left, Side::Right, Side::Top, Side::Bottom}) {
        const BoxParameter t = box_parameter(segment, box, side);
        Passage passage;
        bool empty = false;
        if (t.c == t.d) {
            empty = t.a > t.b;
            passage = empty ? Passage::ParallelOutside : Passage::ParallelInside;
        } else if (t.c > t.d) {
            passage = Passage::Entering;
            empty = compared(t, out) > 0;
            if (!empty && compared(t, in) > 0) in = t, in_side = side;
        } else {
            passage = Passage::Leaving;
            empty = compared(t, in) < 0;
            if (!empty && compared(t, out) < 0) out = t, out_side = side;
        }
        note<BoxParameterFound>(probe, side, t.numerator(), t.denominator(), t.value(), passage, in.value(),
                                out.value(), empty);
        if (empty) return std::nullopt;
    }
    return Segment{in_side ? cross_side(segment, box, *in_side).point : segment.a,
                   out_side ? cross_side(segment, box, *out_side).point : segment.b};
}

}  // namespace relevo::pipeline
