// The order in which the texels of a source may be painted over one another without comparing any depth
// (McMillan, "Computing visibility without depth", UNC TR95-047, 1995; Clua 2004, 3.4.1, its two
// branches exchanged: they are printed the wrong way round).
//
// Texels that meet in one place of the warped picture lie on one line through the epipole, the point of
// the plane that does not move: u_i = w u + (1 - w) e. The nearest of them must be painted last:
//
//     orthographic source                          nearer is closer to the epipole: borders -> epipole
//     perspective, the viewer in front of S        nearer is closer to the epipole: borders -> epipole
//     perspective, the viewer behind S             nearer is farther away:          epipole -> borders
//
// The epipole cuts the picture into up to four sheets; inside of each any order will do that runs one
// way with |u - e_u| and with |v - e_v|. So a line of texels is two runs that meet at the epipole.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "relief/warp.hpp"

namespace relevo::relief {

// An epipole beyond this, or at infinity, is moved here: the order stays what it was.
inline constexpr double farthest_epipole = 1e9;

enum class Painting { Right, Reversed };  // Reversed is wrong: to show what the order is for

struct OcclusionOrder {
    double u, v;         // the epipole, in texels
    bool toward = true;  // from the borders to the epipole; else from the epipole to the borders
};

inline OcclusionOrder occlusion_order(const Warp& warp, Painting painting = Painting::Right) {
    const bool orthographic = warp.projection == Projection::Orthographic,
               toward = orthographic || warp.k3 <= 0;
    const auto epipole = [&](double k) {
        // k3 = 0: the limit of k / k3 from the side on which `toward` holds
        if (warp.k3 == 0) return k == 0 ? 0.0 : std::copysign(farthest_epipole, orthographic ? k : -k);
        return std::clamp(k / warp.k3, -farthest_epipole, farthest_epipole);
    };
    return {epipole(warp.k1), epipole(warp.k2), toward == (painting == Painting::Right)};
}

// How many of a line of `count` texels have their centre before the epipole.
inline int texels_before(double epipole, int count) {
    return static_cast<int>(std::clamp(std::ceil(epipole - 0.5), 0.0, static_cast<double>(count)));
}

// One of the two runs of a line: first, first + step, ..., last. None when count is 0.
struct Run {
    int first, step, count;
};
struct Runs {
    Run run[2];
};
inline Runs runs(double epipole, int count, bool toward) {
    const int before = texels_before(epipole, count), after = count - before;
    if (toward) return {{{0, 1, before}, {count - 1, -1, after}}};
    return {{{before - 1, -1, before}, {before, 1, after}}};
}

// visit(x, y) for every texel of a width x height picture, in an order that paints rightly.
template <class Visit>
void for_each_in_order(const OcclusionOrder& order, int width, int height, Visit&& visit) {
    const Runs rows = runs(order.v, height, order.toward), columns = runs(order.u, width, order.toward);
    for (const Run& row : rows.run)
        for (int j = 0, y = row.first; j < row.count; ++j, y += row.step)
            for (const Run& column : columns.run)
                for (int i = 0, x = column.first; i < column.count; ++i, x += column.step) visit(x, y);
}

// The same for what lies between the texels of a line: gap k is between texel k and texel k + 1, for k =
// -1 and k = count - 1 beyond the ends. The gap that holds the epipole belongs to both runs: it is the
// last, or the first.
inline std::array<Run, 3> gap_runs(double epipole, int count, bool toward) {
    const int before = texels_before(epipole, count), after = count - before;
    if (toward) return {{{-1, 1, before}, {count - 1, -1, after}, {before - 1, 1, 1}}};
    return {{{before - 1, 1, 1}, {before - 2, -1, before}, {before, 1, after}}};
}
template <class Visit>
void for_each_gap(double epipole, int count, bool toward, Visit&& visit) {
    for (const Run& run : gap_runs(epipole, count, toward))
        for (int i = 0, k = run.first; i < run.count; ++i, k += run.step) visit(k);
}

// The gaps between the rows of a source one after another, as steps from row to row: each brings a row (-1
// and `rows`, beyond the borders, are empty), and where it connects, the gap between it and the row of the
// step before is painted.
struct RowStep {
    int row;
    bool connects;
};
inline std::vector<RowStep> row_steps(const OcclusionOrder& order, int rows) {
    const int above = texels_before(order.v, rows);
    std::vector<RowStep> steps;
    int held = -2;  // no row
    for_each_gap(order.v, rows, order.toward, [&](int k) {
        if (held != k && held != k + 1)
            steps.push_back({held = (k < above) == order.toward ? k : k + 1, false});
        steps.push_back({held = held == k ? k + 1 : k, true});
    });
    return steps;
}

}  // namespace relevo::relief
