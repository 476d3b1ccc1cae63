// A picture whose pixels have moved, drawn as the mesh of triangles between them, with a z-buffer: what the
// 3-D warps (view_mesh.hpp), the panoramas (cylinder.hpp) and the morphs (morph.hpp) have in common. They
// differ in where a pixel goes.
//
// A cell whose four pixels are covered and lie within `jump` of one another in depth becomes two triangles;
// otherwise each of its pixels keeps its own quarter of the cell. Depth and colour are perspective-correct.
// Places are snapped to 1/256 pixel.
#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include "raster/interpolate.hpp"
#include "relief/view_image.hpp"

namespace relevo::relief {

enum class Sides { Front, Both };  // whether cells that are turned over are drawn

// Where something goes: a place in the target in pixels, and how deep it lies there, > 0.
struct MovedPoint {
    double u, v, depth;
};

// What is drawn. covered(x, y) is asked for any whole numbers, all else for covered pixels only.
template <class G>
concept MovedGrid = requires(const G& grid, int x, int y, double by) {
    { grid.width() } -> std::convertible_to<int>;
    { grid.height() } -> std::convertible_to<int>;
    { grid.covered(x, y) } -> std::convertible_to<bool>;
    // For `jump`: in which depth the pixel lies.
    { grid.depth(x, y) } -> std::convertible_to<double>;
    // The point of the pixel's own quarter that lies (by, by) pixels beside its centre, each -1/2, 0 or 1/2:
    // its colour, and where it goes; none when the target does not see it. How deep it lies is the grid's
    // choice: most take the pixel's depth.
    { grid.color(x, y, by, by) } -> std::convertible_to<LinearRgb>;
    { grid.moved(x, y, by, by) } -> std::same_as<std::optional<MovedPoint>>;
};

namespace grid_mesh_detail {

struct Corner {
    raster::SnappedCorner window;
    LinearRgb color;
    bool seen;  // and near enough to the target to be snapped
};

template <MovedGrid Grid>
class Drawing {
  public:
    Drawing(const Grid& grid, double jump, std::uint8_t label, Sides sides, ViewImage& into)
        : grid_(grid), jump_(jump), label_(label), sides_(sides), into_(into) {}

    void cell(int x, int y) {
        bool there[4], all = true;
        for (int i = 0; i < 4; ++i) there[i] = grid_.covered(x + i % 2, y + i / 2), all &= there[i];
        if (all && spread(x, y) <= jump_) {
            Corner c[4];
            for (int i = 0; i < 4; ++i) c[i] = corner(x + i % 2, y + i / 2, 0, 0);
            return quad(c);
        }
        for (int i = 0; i < 4; ++i)
            if (there[i]) quarter(x + i % 2, y + i / 2, i % 2 ? -0.5 : 0, i / 2 ? -0.5 : 0);
    }

  private:
    double spread(int x, int y) const {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (int i = 0; i < 4; ++i) {
            const double d = grid_.depth(x + i % 2, y + i / 2);
            low = std::min(low, d), high = std::max(high, d);
        }
        return high - low;
    }

    Corner corner(int x, int y, double by_u, double by_v) const {
        const std::optional<MovedPoint> p = grid_.moved(x, y, by_u, by_v);
        constexpr double most = 2 * pipeline::max_picture_size;
        if (!p || !(std::fabs(p->u) <= most && std::fabs(p->v) <= most)) return {{}, {}, false};
        const auto snapped = [](double place) { return static_cast<std::int32_t>(std::lrint(256 * place)); };
        return {{snapped(p->u), snapped(p->v), 0, static_cast<Scalar>(1 / p->depth)},
                grid_.color(x, y, by_u, by_v),
                true};
    }

    void quarter(int x, int y, double from_u, double from_v) {
        Corner c[4];
        for (int i = 0; i < 4; ++i) c[i] = corner(x, y, from_u + 0.5 * (i % 2), from_v + 0.5 * (i / 2));
        quad(c);
    }
    void quad(const Corner (&c)[4]) {  // upper left, upper right, lower left, lower right
        triangle(c[0], c[1], c[3]);
        triangle(c[0], c[3], c[2]);
    }

    void triangle(const Corner& a, const Corner& b, const Corner& c) {
        if (!a.seen || !b.seen || !c.seen) return;
        const std::int64_t area = raster::area2(a.window, b.window, c.window);
        if (area == 0 || (area < 0 && sides_ == Sides::Front)) return;
        const raster::SnappedCorner window[3] = {a.window, b.window, c.window};
        const raster::PixelBox box = raster::pixel_box(window, into_.width(), into_.height());
        if (box.empty()) return;
        const Corner* const corners[3] = {&a, &b, &c};
        const auto [order] = raster::canonical_order(a.window, b.window, c.window, area > 0);
        const Corner &c0 = *corners[order[0]], &c1 = *corners[order[1]], &c2 = *corners[order[2]];
        const raster::Triangle t = raster::make_triangle(c0.window, c1.window, c2.window);
        const raster::Interpolator interpolator = raster::make_interpolator(t);
        const auto color = [](const Corner& k) {
            return std::array<Scalar, 3>{k.color.r, k.color.g, k.color.b};
        };
        const auto plane = raster::make_plane<3>(color(c0), color(c1), color(c2));
        raster::for_each_span(t, box, [&](int y, raster::Span span, raster::EdgeValues) {
            for (int x = span.x0; x < span.x1; ++x) {
                const auto weights = raster::perspective_weights(interpolator, raster::edge_values(t, x, y));
                const auto depth = static_cast<Scalar>(static_cast<double>(t.area) / weights.s);
                if (into_.coverage.at(x, y) && !(depth < into_.depth.at(x, y))) continue;
                const auto [r, g, u] = raster::interpolate(plane, weights);
                into_.coverage.at(x, y) = label_, into_.depth.at(x, y) = depth;
                into_.color.at(x, y) = {r, g, u};
            }
        });
    }

    const Grid& grid_;
    double jump_;
    std::uint8_t label_;
    Sides sides_;
    ViewImage& into_;
};

}  // namespace grid_mesh_detail

// Draws what is nearer than what is there. Where it draws, coverage becomes `label` (not 0).
template <MovedGrid Grid>
void draw_grid_mesh(const Grid& grid, double jump, ViewImage& into, std::uint8_t label = 1,
                    Sides sides = Sides::Front) {
    assert(label != 0);
    grid_mesh_detail::Drawing<Grid> drawing(grid, jump, label, sides, into);
    for (int y = -1; y < grid.height(); ++y)
        for (int x = -1; x < grid.width(); ++x) drawing.cell(x, y);
}

}  // namespace relevo::relief
