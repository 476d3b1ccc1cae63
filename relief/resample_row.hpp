// The horizontal half of every resampler: the texels of one source row, warped, and the samples at the pixel
// columns between them.
#pragma once
#include "pipeline/probe.hpp"
#include "relief/resample_line.hpp"

namespace relevo::relief {

// One row of the source after the warp. Places are in pixels of the window; of empty texels nothing has a
// meaning.
template <bool maps>
struct WarpedRow {
    int y = 0;                             // of the source
    std::vector<Scalar> depth;             // behind the plane, in world units
    std::vector<Scalar> u, v;              // where each texel goes
    std::vector<int> column;               // first_pixel(u)
    std::vector<Gap> gap;                  // k + 1: between the texels k and k + 1
    std::vector<Scalar> slope_u, slope_v;  // slope_beyond() along the row and across it
    std::vector<Carried<maps>> carried;

    WarpedRow() = default;
    explicit WarpedRow(int count)
        : depth(count),
          u(count),
          v(count),
          column(count),
          gap(count + 1),
          slope_u(count),
          slope_v(count),
          carried(count) {}
};

// A sample of a row at the middle of a pixel column.
template <bool maps>
struct RowSample {
    Carried<maps> carried;
    Scalar v = 0;      // where it goes, in pixels of the window
    Scalar slope = 0;  // of the depth beyond it, across the row
    Kind kind = Kind::Empty;
};

// The depth behind the plane of a texel, in world units; 0 where there is none.
inline Scalar depth_behind_plane(const ReliefTexture& texture, Scalar source_h, int x, int y) {
    if (!texture.coverage.row(y)[x]) return 0;
    const Scalar stored = texture.depth.row(y)[x];
    return texture.camera.projection == Projection::Orthographic ? stored
                                                                 : source_h * ((1 - stored) / stored);
}

template <bool maps>
class RowWarper {
  public:
    RowWarper(const ReliefTexture& texture, const Warp& warp, const Window& window,
              const PrewarpSettings& settings)
        : texture_(texture),
          settings_(settings),
          window_(window),
          k1_(static_cast<Scalar>(warp.k1)),
          k2_(static_cast<Scalar>(warp.k2)),
          k3_(static_cast<Scalar>(warp.k3)),
          source_h_(static_cast<Scalar>(warp.source_h)),
          perspective_(warp.projection == Projection::Perspective) {}

    void operator()(int y, WarpedRow<maps>& row) const {
        row.y = y;
        perspective_ ? warp_texels<true>(y, row) : warp_texels<false>(y, row);
        find_gaps(y, row);
        find_slopes(y, row);
    }

  private:
    // Empty texels are warped with the rest, as if they lay on the plane: no branch, and nothing undefined.
    template <bool perspective>
    void warp_texels(int y, WarpedRow<maps>& row) const {
        const int count = texture_.camera.width;
        const Scalar at_v = static_cast<Scalar>(y) + Scalar(0.5), x0 = static_cast<Scalar>(window_.x0),
                     y0 = static_cast<Scalar>(window_.y0);
        const Scalar* const depth = texture_.depth.row(y);
        const std::uint8_t* const covered = texture_.coverage.row(y);
        const LinearRgb* const color = texture_.color.row(y);
        const Vec3* const normal = texture_.normal.row(y);
        for (int x = 0; x < count; ++x) {
            const Scalar stored = covered[x] ? depth[x] : Scalar(perspective),
                         q = perspective ? stored - 1 : stored, w = 1 / (1 + k3_ * q),
                         weight = perspective ? stored * w : w;
            row.depth[x] = perspective ? source_h_ * ((1 - stored) / stored) : stored;
            row.u[x] = ((static_cast<Scalar>(x) + Scalar(0.5)) + k1_ * q) * w - x0;
            row.v[x] = (at_v + k2_ * q) * w - y0;
            row.column[x] = first_pixel(row.u[x], window_.width);
            Carried<maps>& c = row.carried[x];
            c.slot[c.red] = color[x].r * weight;
            c.slot[c.green] = color[x].g * weight;
            c.slot[c.blue] = color[x].b * weight;
            c.slot[c.depth] = row.depth[x] * weight;
            c.slot[c.normal_x] = normal[x].x * weight;
            c.slot[c.normal_y] = normal[x].y * weight;
            c.slot[c.normal_z] = normal[x].z * weight;
            c.slot[c.weight] = weight;
            if constexpr (maps) {
                c.slot[c.source_u] = (static_cast<Scalar>(x) + Scalar(0.5)) * weight;
                c.slot[c.source_v] = at_v * weight;
                c.slot[c.source_v + 1] = c.slot[c.source_v + 2] = 0;
            }
        }
    }

    void find_gaps(int y, WarpedRow<maps>& row) const {
        const int count = texture_.camera.width;
        const std::uint8_t* const covered = texture_.coverage.row(y);
        row.gap[0] = gap(false, covered[0], 0, 0, settings_);
        for (int x = 0; x + 1 < count; ++x)
            row.gap[x + 1] = gap(covered[x], covered[x + 1], row.depth[x], row.depth[x + 1], settings_);
        row.gap[count] = gap(covered[count - 1], false, 0, 0, settings_);
    }

    Scalar depth_at(int x, int y) const { return depth_behind_plane(texture_, source_h_, x, y); }
    bool covered_at(int x, int y) const {
        return 0 <= y && y < texture_.camera.height && texture_.coverage.row(y)[x];
    }
    void find_slopes(int y, WarpedRow<maps>& row) const {
        const int count = texture_.camera.width;
        for (int x = 0; x < count; ++x) {
            if (!covered_at(x, y)) continue;
            const Scalar here = row.depth[x];
            const auto across = [&](int other) {
                const bool there = covered_at(x, other);
                return std::pair(gap(true, there, here, there ? depth_at(x, other) : 0, settings_),
                                 there ? depth_at(x, other) : 0);
            };
            const auto [above, depth_above] = across(y - 1);
            const auto [below, depth_below] = across(y + 1);
            row.slope_v[x] = slope_beyond(above, depth_above, below, depth_below, here);
            row.slope_u[x] = slope_beyond(row.gap[x], x > 0 ? row.depth[x - 1] : 0, row.gap[x + 1],
                                          x + 1 < count ? row.depth[x + 1] : 0, here);
        }
    }

    const ReliefTexture& texture_;
    PrewarpSettings settings_;
    Window window_;
    Scalar k1_, k2_, k3_, source_h_;
    bool perspective_;
};

// emit(x, sample) for each sample of the row, in the order of painting; x: pixel column. between(k, t): what
// is carried at t between the texels k and k + 1.
template <bool maps, class Between, class Emit>
void resample_row(const WarpedRow<maps>& row, const DepthWarp& warp, const OcclusionOrder& order,
                  const Window& window, Between&& between, Emit&& emit) {
    const int count = static_cast<int>(row.u.size());
    // From texel k half a texel to the left (-1) or to the right (1).
    const auto stick_out = [&](int k, int side) {
        const Carried<maps>&c = row.carried[k], end = half_texel_beyond(c, row.slope_u[k], warp);
        const Scalar place = static_cast<Scalar>(2 * k + 1 + side) / 2, u = row.u[k], v = row.v[k],
                     u_end = warped_u_of(end, place, warp) - static_cast<Scalar>(window.x0),
                     v_end = warped_v_of(end, static_cast<Scalar>(row.y) + Scalar(0.5), warp) -
                             static_cast<Scalar>(window.y0);
        const int from = row.column[k], to = first_pixel(u_end, window.width);
        const Scalar inverse = 1 / (u_end - u);
        for (int x = std::min(from, to); x < std::max(from, to); ++x) {
            const Scalar t = (static_cast<Scalar>(x) + Scalar(0.5) - u) * inverse;
            emit(x, RowSample<maps>{lerp(c, end, t), v + t * (v_end - v), row.slope_v[k], Kind::Sampled});
        }
    };
    for_each_gap(order.u, count, order.toward, [&](int k) {
        const Gap gap = row.gap[k + 1];
        if (gap == Gap::AfterFirst || gap == Gap::Cut) stick_out(k, 1);
        if (gap == Gap::BeforeSecond || gap == Gap::Cut) stick_out(k + 1, -1);
        if (sticks_out(gap)) return;
        const int from = std::min(row.column[k], row.column[k + 1]),
                  to = std::max(row.column[k], row.column[k + 1]);
        if (from == to) return;
        const Scalar u = row.u[k], v = row.v[k], slope = row.slope_v[k], inverse = 1 / (row.u[k + 1] - u);
        for (int x = from; x < to; ++x) {
            const Scalar at = static_cast<Scalar>(x) + Scalar(0.5), t = (at - u) * inverse;
            const Kind kind =
                maps ? kind_between(at, u, row.u[k + 1], Kind::Sampled, Kind::Sampled, gap == Gap::Across)
                     : Kind::Sampled;
            emit(x, RowSample<maps>{between(k, t), v + t * (row.v[k + 1] - v),
                                    slope + t * (row.slope_v[k + 1] - slope), kind});
        }
    });
}

}  // namespace relevo::relief
