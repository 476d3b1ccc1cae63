// Parametric line clipping against a convex polygon (Cyrus and Beck 1978; textbook section 4.1.2, algorithm
// 4.1, figures 4.4 and 4.5).
//
// The segment is P(t) = P0 + D t, D = P1 - P0, 0 <= t <= 1. With a point PL on a side and its normal N, which
// points outwards, the segment crosses the side's line at
//
//   t = N . (P0 - PL) / (-N . D)
//
// A positive denominator means that it enters the half-plane of the side there, a negative one that it leaves
// (the sign belongs to the cosine of the angle between N and D); 0: it is parallel, and outside when the
// numerator is positive. It is visible from the last entering t to the first leaving one. Values of t are
// compared as fractions, exactly; only the two ends that remain become points, each coordinate correctly
// rounded. Half a unit of its last place is what such a point can lie beyond a slanted side.
//
// A window that is not convex would silently give wrong answers, so it is refused; coordinates that are not
// finite, too. Time is linear in the sides, and checking the window is, so convex_window() may be kept.
#pragma once
#include <optional>

#include "pipeline/clip_plane.hpp"

namespace relevo::pipeline {

struct SideParameterFound {  // event: one side of the window. Numbers are rounded for show.
    std::size_t side;        // of the window that convex_window() made
    ClipLine line;
    double normal_x, normal_y, numerator, denominator;
    double t;  // not a number when parallel
    Passage passage;
    double t_in, t_out;  // after it
    bool empty;          // nothing is left: the segment is rejected here
};

// Where the segment crosses a side's line, as a fraction; without a line 0 or 1, the ends.
struct SideParameter {
    const ClipLine* line = nullptr;
    double end = 0;
};
template <class As>
auto parameter(As n, const Segment& s, const SideParameter& t) {
    if (!t.line) return Fraction{n(float(t.end)), n(1)};
    const ClipLine& l = *t.line;
    return Fraction{cross(n, l.from, l.to, s.a, l.from), cross(n, l.from, l.to, s.a, s.b)};
}

// The sign of s - t for two crossings of one segment; `sign` is that of the denominators' product.
inline int compared(const Segment& segment, const SideParameter& s, const SideParameter& t, int sign) {
    return sign * sign_of([&](auto n) {
               const auto [s_top, s_bottom] = parameter(n, segment, s);
               const auto [t_top, t_bottom] = parameter(n, segment, t);
               return s_top * t_bottom - t_top * s_bottom;
           });
}

template <class Probe = const NoProbe>
std::optional<Segment> clip_line_cyrus_beck(const Segment& segment, std::span<const ClipLine> window,
                                            Probe&& probe = {}) {
    if (!is_finite(segment)) return note<ClipRefused>(probe, Refusal::NotFinite), std::nullopt;
    SideParameter in{nullptr, 0}, out{nullptr, 1};  // denominators: in's is never negative, out's by its line
    const auto value = [&](const SideParameter& t) {
        const auto [top, bottom] = parameter(As<Bounded>{}, segment, t);
        return top.value / bottom.value;
    };
    for (std::size_t i = 0; i < window.size(); ++i) {
        const ClipLine& line = window[i];
        const SideParameter t{&line};
        const int denominator = sign_of_cross(line.from, line.to, segment.a, segment.b);
        const int out_sign = out.line ? -1 : 1;
        Passage passage;
        bool empty = false;
        if (denominator == 0) {
            empty = side_of(line, segment.a) < 0;
            passage = empty ? Passage::ParallelOutside : Passage::ParallelInside;
        } else if (denominator > 0) {
            passage = Passage::Entering;
            empty = compared(segment, t, out, out_sign) > 0;
            if (!empty && compared(segment, t, in, 1) > 0) in = t;
        } else {
            passage = Passage::Leaving;
            empty = compared(segment, t, in, -1) < 0;
            if (!empty && compared(segment, t, out, -out_sign) < 0) out = t;
        }
        if constexpr (Wants<Probe, SideParameterFound>) {
            const auto [top, bottom] = parameter(As<Bounded>{}, segment, t);
            note<SideParameterFound>(probe, i, line, double{line.to.y} - double{line.from.y},
                                     double{line.from.x} - double{line.to.x}, top.value, bottom.value,
                                     denominator == 0 ? NAN : top.value / bottom.value, passage, value(in),
                                     value(out), empty);
        }
        if (empty) return std::nullopt;
    }
    return Segment{in.line ? meeting_point(segment, *in.line) : segment.a,
                   out.line ? meeting_point(segment, *out.line) : segment.b};
}

// The same for a window given by its corners, in either winding.
template <class Probe = const NoProbe>
std::optional<Segment> clip_line_cyrus_beck(const Segment& segment, std::span<const glm::vec2> polygon,
                                            Probe&& probe = {}) {
    const auto window = convex_window(polygon);
    if (!window) return note<ClipRefused>(probe, window.error()), std::nullopt;
    return clip_line_cyrus_beck(segment, std::span<const ClipLine>(*window), probe);
}

// The same for a box, which may be a line or a point.
template <class Probe = const NoProbe>
std::optional<Segment> clip_line_cyrus_beck(const Segment& segment, const ClipBox& box, Probe&& probe = {}) {
    if (!is_window(box)) return note<ClipRefused>(probe, refusal_of(box)), std::nullopt;
    const auto sides = lines_of(box);
    return clip_line_cyrus_beck(segment, std::span<const ClipLine>(sides), probe);
}

}  // namespace relevo::pipeline
