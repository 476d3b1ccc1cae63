// The horizontal half of every resampler: the texels of one source row, warped, and the samples at the
// pixel columns between them.
#pragma once
#include "pipeline/probe.hpp"
#include "relief/resample_line.hpp"

namespace relevo::relief {

// One row of the source after the warp, between its first and its last surface. Places are in pixels of
// the window. Empty texels are warped with the rest, as if they lay on the plane: no branch, and nothing
// undefined.
struct WarpedRow {
    int y = -1;                // of the source
    std::vector<Scalar> u, v;  // where each texel goes
    std::vector<Scalar> weight;
    std::vector<int> column;  // first_pixel(u)
    explicit WarpedRow(int count)
        : u(std::size_t(count)),
          v(std::size_t(count)),
          weight(std::size_t(count)),
          column(std::size_t(count)) {}
};

inline void warp_row(const PreparedRelief& relief, const Warp& warp, const Window& window, int y,
                     WarpedRow& row) {
    const Scalar k1 = static_cast<Scalar>(warp.k1), k2 = static_cast<Scalar>(warp.k2),
                 k3 = static_cast<Scalar>(warp.k3), at_v = static_cast<Scalar>(y) + Scalar(0.5),
                 x0 = static_cast<Scalar>(window.x0), y0 = static_cast<Scalar>(window.y0),
                 width = static_cast<Scalar>(window.width),
                 perspective = warp.projection == Projection::Perspective ? 1 : 0;
    const Scalar* const parameter = relief.parameter.row(y);
    Scalar *const u = row.u.data(), *const v = row.v.data(), *const weight = row.weight.data();
    int* const column = row.column.data();
    const raster::Span covered = relief.covered[std::size_t(y)];
    row.y = y;
    for (int x = covered.x0; x < covered.x1; ++x) {
        const Scalar q = parameter[x], w = 1 / (1 + k3 * q);
        u[x] = ((static_cast<Scalar>(x) + Scalar(0.5)) + k1 * q) * w - x0;
        v[x] = (at_v + k2 * q) * w - y0;
        weight[x] = (1 + perspective * q) * w;
    }
    for (int x = covered.x0; x < covered.x1; ++x) column[x] = first_pixel(u[x], width);
}

// A sample of a row at the middle of a pixel column.
template <bool maps>
struct RowSample {
    Carried<maps> carried;
    Scalar v = 0;  // where it goes, in pixels of the window
    Scalar weight = 1;
    Kind kind = Kind::Empty;
};

// What texel (x, y) carries, c, as a resampler takes it along: the maps want to know where it came from,
// too.
template <bool maps>
[[gnu::always_inline]] inline decltype(auto) carried_by(const Carried<false>& c, int x, int y) {
    if constexpr (maps)
        return Carried<true>{
            {c.part[0], c.part[1],
             Four{static_cast<Scalar>(x) + Scalar(0.5), static_cast<Scalar>(y) + Scalar(0.5)}}};
    else
        return (c);
}

// A texel, or the end of the half texel that sticks out of it.
template <bool maps>
struct RowEnd {
    const Carried<maps>& carried;
    Scalar u, v, weight;
    int column;
};

// The samples between a and b, a being the texel of the lower number or that of which b sticks out.
template <bool maps, class Method, class Emit>
[[gnu::always_inline]] inline void sample_between(const RowEnd<maps>& a, const RowEnd<maps>& b, bool across,
                                                  const DepthWarp& warp, Emit& emit) {
    const int from = std::min(a.column, b.column), to = std::max(a.column, b.column);
    if (from == to) return;
    const Scalar inverse = 1 / (b.u - a.u);
    for (int x = from; x < to; ++x) {
        const Scalar at = static_cast<Scalar>(x) + Scalar(0.5), t = (at - a.u) * inverse,
                     weight = a.weight + t * (b.weight - a.weight);
        RowSample<maps>& sample = emit(x);
        sample.carried = lerp(a.carried, b.carried, t * b.weight / weight);
        sample.v = a.v + t * (b.v - a.v);
        sample.weight = weight;
        sample.kind = maps ? kind_between(at, a.u, b.u, Kind::Sampled, Kind::Sampled, across) : Kind::Sampled;
        Method::adjust(sample, a.carried, b.carried, t, warp);
    }
}

// The samples from texel k half a texel to the left (side -1) or to the right (1).
template <bool maps, class Method, class Emit>
[[gnu::noinline]] void stick_out_of_row(const PreparedRelief& relief, const WarpedRow& row, int k, int side,
                                        const DepthWarp& warp, const Window& window, Emit& emit) {
    const auto i = static_cast<std::size_t>(k);
    const Carried<maps> c = carried_by<maps>(relief.carried.row(row.y)[k], k, row.y);
    Carried<maps> end = c;
    const Scalar depth = depth_beyond(c.depth(), relief.slope_u.row(row.y)[k]),
                 weight = weight_at(depth, warp),
                 u = warped_u(static_cast<Scalar>(2 * k + 1 + side) / 2, depth, warp) -
                     static_cast<Scalar>(window.x0),
                 v = warped_v(static_cast<Scalar>(row.y) + Scalar(0.5), depth, warp) -
                     static_cast<Scalar>(window.y0);
    end.set_depth(depth);
    sample_between<maps, Method>({c, row.u[i], row.v[i], row.weight[i], row.column[i]},
                                 {end, u, v, weight, first_pixel(u, static_cast<Scalar>(window.width))},
                                 false, warp, emit);
}

// The samples of a row in the order of painting. emit(x) gives the place for the sample of pixel column
// x. Method: what is interpolated how (resample_two_passes.hpp).
template <bool maps, class Method, class Emit>
void resample_row(const PreparedRelief& relief, const WarpedRow& row, const DepthWarp& warp,
                  const OcclusionOrder& order, const Window& window, Emit&& emit) {
    const raster::Span covered = relief.covered[std::size_t(row.y)];
    if (covered.x0 >= covered.x1) return;
    const Gap* const gaps = relief.gap.row(row.y) + 1;
    const Carried<false>* const carried = relief.carried.row(row.y);
    const Scalar *const u = row.u.data(), *const v = row.v.data(), *const weight = row.weight.data();
    const int *const column = row.column.data(), y = row.y;
    for_each_gap(order.u - covered.x0, covered.x1 - covered.x0, order.toward,
                 [=, &relief, &row, &warp, &window, &emit](int i) {
                     const int k = i + covered.x0;
                     const Gap gap = gaps[k];
                     if (gap >= Gap::Joined) {
                         if (column[k] == column[k + 1]) return;
                         sample_between<maps, Method>(
                             {carried_by<maps>(carried[k], k, y), u[k], v[k], weight[k], column[k]},
                             {carried_by<maps>(carried[k + 1], k + 1, y), u[k + 1], v[k + 1], weight[k + 1],
                              column[k + 1]},
                             gap == Gap::Across, warp, emit);
                     } else if (gap != Gap::Empty) {
                         if (gap != Gap::BeforeSecond)
                             stick_out_of_row<maps, Method>(relief, row, k, 1, warp, window, emit);
                         if (gap != Gap::AfterFirst)
                             stick_out_of_row<maps, Method>(relief, row, k + 1, -1, warp, window, emit);
                     }
                 });
}

}  // namespace relevo::relief
