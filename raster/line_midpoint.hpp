// The midpoint line in all eight octants, integers only (Bresenham 1965 in the form of Pitteway 1967;
// textbook section 5.1, algorithm 5.1).
//
// One pixel a step along the major coordinate. After a pixel only two can follow: straight on (E) or one to
// the side as well (the diagonal: NE in the first octant). The line F(x, y) = 0 passes nearer to the one on
// its side of the midpoint M between them, so the sign of d = 2 F(M) decides, and d is carried by additions:
//
//     d = 2 minor - major       d <= 0:  E,         d += 2 minor
//                               d > 0:   diagonal,  d += 2 (minor - major)
//
// Rule: the walk starts at the end with the smaller major coordinate (line_walk.hpp), and a tie, d = 0, goes
// straight on. So A to B lights the pixels of B to A. Both ends are lit; every pixel lies within half a pixel
// of the true line, measured across.
//
// A line that starts outside the box is entered with the d that the uncut line has there: it lights exactly
// the pixels of the uncut line, and steps outside cost nothing. Any two pixels of the int32 plane are fine:
// -2^33 < d < 2^33.
#pragma once
#include "pipeline/probe.hpp"
#include "raster/line_walk.hpp"

namespace relevo::raster {

// The line is known: its walk, the first d, and what a step adds to it.
struct LineStarted {
    LineWalk walk;
    std::int64_t d, straight, diagonal;
};

// The choice after a pixel in the box; there is none after the last.
struct LineStep {
    std::int64_t step;                         // of the uncut line, from 0
    Pixel pixel;                               // lit
    std::int64_t d;                            // decides: > 0 is diagonal
    bool diagonal;                             // chosen
    GridPoint straight_pixel, diagonal_pixel;  // the candidates
    GridPoint twice_midpoint;                  // their sum
};

namespace line_midpoint_detail {

template <class Probe>
void note_step(const LineWalk& walk, std::int64_t step, Pixel at, std::int64_t d, Probe& probe) {
    if constexpr (pipeline::Wants<Probe, LineStep>) {
        const std::int64_t x = at.x, y = at.y;
        const GridPoint straight = walk.steep ? GridPoint{x, y + 1} : GridPoint{x + 1, y};
        const GridPoint diagonal =
            walk.steep ? GridPoint{x + walk.side, y + 1} : GridPoint{x + 1, y + walk.side};
        pipeline::note<LineStep>(probe, step, at, d, d > 0, straight, diagonal,
                                 GridPoint{straight.x + diagonal.x, straight.y + diagonal.y});
    }
}

// The loop carries -d: its sign is the choice, as a mask, since no processor foresees such a branch.
template <bool steep, class Plot, class Probe>
void walk_steps(const LineWalk& walk, const LineSteps& steps, Plot& plot, Probe& probe) {
    const std::int64_t straight = 2 * walk.minor, back = 2 * walk.major;
    const std::int64_t offset = line_offset(walk, steps.first);
    auto minus_d = static_cast<std::int64_t>(Int128{walk.major} * (2 * offset + 1) -
                                             2 * Int128{walk.minor} * (steps.first + 1));
    auto [x, y] = line_pixel(walk, steps.first, offset);
    for (std::int64_t step = steps.first;; ++step) {
        plot(static_cast<int>(x), static_cast<int>(y));
        if (step == steps.last) return;
        note_step(walk, step, {x, y}, -minus_d, probe);
        const std::int64_t diagonal = minus_d >> 63;  // all bits when d > 0, else none
        minus_d += (back & diagonal) - straight;
        (steep ? x : y) += walk.side & static_cast<int>(diagonal);
        ++(steep ? y : x);
    }
}

}  // namespace line_midpoint_detail

// Calls plot(x, y) for each pixel of the line in the box, from the start of the walk to its end.
template <class Plot, class Probe = const pipeline::NoProbe>
void line_midpoint(Pixel a, Pixel b, const PixelBox& box, Plot&& plot, Probe&& probe = {}) {
    const LineWalk walk = line_walk(a, b);
    pipeline::note<LineStarted>(probe, walk, 2 * walk.minor - walk.major, 2 * walk.minor,
                                2 * (walk.minor - walk.major));
    const LineSteps steps = steps_in(walk, box);
    if (steps.empty()) return;
    walk.steep ? line_midpoint_detail::walk_steps<true>(walk, steps, plot, probe)
               : line_midpoint_detail::walk_steps<false>(walk, steps, plot, probe);
}

}  // namespace relevo::raster
