// The reference of the resamplers: every cell between four texels is two triangles in the warped
// picture, rasterized exactly (raster/triangle_edge.hpp) and compared by depth. No order to trust, no
// pass after pass; slow.
//
// The triangle's own weights, corrected for the perspective, interpolate what is carried. Where a cell
// lacks a corner, or is cut, its texels still have the half texel of their own that the other resamplers
// give them. Corners are snapped to 1/256 pixel; those farther than a picture's width beyond the window
// are moved there.
#pragma once
#include "raster/triangle_edge.hpp"
#include "relief/resample_column.hpp"

namespace relevo::relief {

template <bool maps>
struct MeshCorner {
    Scalar u, v, weight;
    Carried<maps> carried;
    Scalar source_u, source_v, growth_u;
};

template <bool maps>
class MeshResampler {
  public:
    MeshResampler(const PreparedRelief& relief, const Warp& warp, Prewarped& result)
        : relief_(relief),
          warp_(warp),
          constants_(warp),
          window_(result.window),
          painter_(result, true),
          upper_(make_warped_row()),
          lower_(make_warped_row()) {
        clear_columns(result, 0, window_.width);
    }

    void run() {
        const int height = relief_.camera.height;
        for (int y = -1; y < height; ++y) {  // cells between the rows y and y + 1
            std::swap(upper_, lower_);
            if (y + 1 < height) warp_row(relief_, warp_, window_, whole(window_), y + 1, *lower_);
            for (int x = -1; x < relief_.camera.width; ++x) draw_cell(x, y);
        }
    }

  private:
    using Corner = MeshCorner<maps>;

    bool covered(int x, int y) const { return relief_.carried.holds(x, y) && is_covered(relief_, x, y); }
    Corner corner(int x, const WarpedRow& row) const {
        return {row.u[x],
                row.v[x],
                row.weight[x],
                carried_by<maps>(relief_.carried.at(x, row.y), x, row.y),
                static_cast<Scalar>(x) + Scalar(0.5),
                static_cast<Scalar>(row.y) + Scalar(0.5),
                relief_.growth_u.at(x, row.y)};
    }
    // Half a texel away, along each axis: -1, 0 or 1.
    Corner moved(Corner c, int along_u, int along_v) const {
        const Scalar growth = (along_u ? c.growth_u : 0) + (along_v ? c.carried.growth() : 0),
                     depth = depth_beyond(c.carried.depth(), growth);
        c.carried.set_depth(depth), c.weight = weight_at(depth, constants_);
        c.source_u += Scalar(0.5) * static_cast<Scalar>(along_u);
        c.source_v += Scalar(0.5) * static_cast<Scalar>(along_v);
        c.u = warped_u(c.source_u, depth, constants_) - static_cast<Scalar>(window_.x0);
        c.v = warped_v(c.source_v, depth, constants_) - static_cast<Scalar>(window_.y0);
        return c;
    }
    Gap between(const Corner& a, const Corner& b) const {
        return gap_between(true, true, a.carried.depth(), b.carried.depth(), relief_.jump,
                           relief_.jump_depth);
    }

    // The cell whose corners are the texels (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1).
    void draw_cell(int x, int y) {
        Corner c[4];
        bool there[4], all = true;
        for (int i = 0; i < 4; ++i) {
            there[i] = covered(x + i % 2, y + i / 2), all &= there[i];
            if (there[i]) c[i] = corner(x + i % 2, i / 2 ? *lower_ : *upper_);
        }
        bool across = false, cut = false;
        if (all)
            for (const auto& [i, j] : {std::pair(0, 1), {0, 2}, {1, 3}, {2, 3}, {0, 3}, {1, 2}}) {
                const Gap g = between(c[i], c[j]);
                across |= g == Gap::Across, cut |= g == Gap::Cut;
            }
        if (all && !cut) return draw_quad(c[0], c[1], c[2], c[3], across ? Kind::FilledAcross : Kind::Filled);
        for (int i = 0; i < 4; ++i) {
            if (!there[i]) continue;
            const int right = i % 2 ? -1 : 1, down = i / 2 ? -1 : 1;  // towards the middle of the cell
            draw_quad(c[i], moved(c[i], right, 0), moved(c[i], 0, down), moved(c[i], right, down),
                      Kind::Sampled);
            const int across_u = i ^ 1, across_v = i ^ 2;
            if (across_u > i && there[across_u]) draw_edge(c[i], c[across_u], 0, down);
            if (across_v > i && there[across_v]) draw_edge(c[i], c[across_v], right, 0);
        }
    }
    void draw_edge(const Corner& a, const Corner& b, int along_u, int along_v) {
        const Gap g = between(a, b);
        if (g == Gap::Cut) return;
        draw_quad(a, b, moved(a, along_u, along_v), moved(b, along_u, along_v),
                  g == Gap::Across ? Kind::FilledAcross : Kind::Filled);
    }

    void draw_quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d, Kind filled) {
        draw_triangle(a, b, d, filled);
        draw_triangle(a, d, c, filled);
    }

    void draw_triangle(const Corner& a, const Corner& b, const Corner& c, Kind filled) {
        const Corner* const corner[3] = {&a, &b, &c};
        raster::SnappedCorner s[3];
        for (int i = 0; i < 3; ++i) s[i] = snapped(*corner[i]);
        const std::int64_t area = raster::area2(s[0], s[1], s[2]);
        const raster::PixelBox box = raster::pixel_box(s, window_.width, window_.height);
        if (area == 0 || box.empty()) return;
        const raster::CornerOrder order = raster::canonical_order(s[0], s[1], s[2], area > 0);
        const int i0 = order.index[0], i1 = order.index[1], i2 = order.index[2];
        const raster::Triangle triangle = raster::make_triangle(s[i0], s[i1], s[i2]);
        const Carried<maps>&c0 = corner[i0]->carried, &c1 = corner[i1]->carried, &c2 = corner[i2]->carried;
        raster::for_each_span(triangle, box, [&](int y, raster::Span span, raster::EdgeValues) {
            for (int x = span.x0; x < span.x1; ++x) {
                const raster::EdgeValues e = raster::edge_values(triangle, x, y);
                const double w0 = static_cast<double>(e.e0) * double{corner[i0]->weight},
                             w1 = static_cast<double>(e.e1) * double{corner[i1]->weight},
                             w2 = static_cast<double>(e.e2) * double{corner[i2]->weight},
                             sum = w0 + (w1 + w2);
                const Scalar b1 = static_cast<Scalar>(w1 / sum), b2 = static_cast<Scalar>(w2 / sum);
                Carried<maps> mixed;
                for (int k = 0; k < Carried<maps>::parts; ++k)
                    mixed.part[k] =
                        c0.part[k] + (b1 * (c1.part[k] - c0.part[k]) + b2 * (c2.part[k] - c0.part[k]));
                painter_.paint(x, y, mixed, is_near(x, y, a, b, c) ? Kind::Sampled : filled);
            }
        });
    }

    // Within half a pixel of a texel, along both axes.
    static bool is_near(int x, int y, const Corner& a, const Corner& b, const Corner& c) {
        const auto near = [&](const Corner& at) {
            return std::abs(static_cast<Scalar>(x) + Scalar(0.5) - at.u) <= Scalar(0.5) &&
                   std::abs(static_cast<Scalar>(y) + Scalar(0.5) - at.v) <= Scalar(0.5);
        };
        return near(a) || near(b) || near(c);
    }

    static raster::SnappedCorner snapped(const Corner& c) {
        const auto on_grid = [](Scalar place) {
            constexpr double most = 2 * pipeline::max_picture_size;
            return static_cast<std::int32_t>(
                std::lrint(256 * std::clamp(static_cast<double>(place), -most, most)));
        };
        return {on_grid(c.u), on_grid(c.v), 0, 0};
    }

    const PreparedRelief& relief_;
    Warp warp_;
    DepthWarp constants_;
    Window window_;
    Painter<maps> painter_;
    std::unique_ptr<WarpedRow> upper_, lower_;
};

}  // namespace relevo::relief
