// A relief texture drawn straight to a viewer's screen, as the mesh of triangles between its texels, with a
// z-buffer: every texel by McMillan's 3-D warp (warp_3d.hpp), none by way of a plane.
//
// So it needs no plane in front of the viewer, and the textures of many planes can be drawn into one picture,
// the nearest point of all of them winning: the faces of a box, or depth images placed at any angle.
//
// A cell whose four texels are covered and lie within `jump` of one another (world units along f) becomes two
// triangles; otherwise each of its texels keeps its own quarter of the cell, at its own depth. What a texel
// shows is one side of the surface: triangles that turn their back to the viewer, seen from where the source
// is not, are drawn only when the texture holds surfaces of both sides. Depth and colour are perspective-
// correct.
#pragma once
#include <cmath>
#include <limits>

#include "raster/interpolate.hpp"
#include "relief/view_image.hpp"
#include "relief/warp_3d.hpp"

namespace relevo::relief {

enum class Sides { Front, Both };

namespace view_mesh_detail {

struct Corner {
    raster::SnappedCorner window;
    LinearRgb color;
    bool seen;  // in front of the eye, and near enough to the screen to be snapped
};

class Drawing {
  public:
    Drawing(const ReliefTexture& texture, const ReliefCamera& viewer, double jump, std::uint8_t label,
            Sides sides, ViewImage& into)
        : texture_(texture),
          viewer_(viewer),
          screen_from_world_(glm::inverse(sight_matrix(viewer))),
          distance_(view_depth(viewer, viewer.corner)),
          jump_(jump),
          label_(label),
          sides_(sides),
          into_(into) {}

    void cell(int x, int y) {
        bool there[4], all = true;
        for (int i = 0; i < 4; ++i) there[i] = covered(x + i % 2, y + i / 2), all &= there[i];
        if (all && spread(x, y) <= jump_) {
            Corner c[4];
            for (int i = 0; i < 4; ++i) c[i] = corner(x + i % 2, y + i / 2, 0, 0);
            return quad(c);
        }
        for (int i = 0; i < 4; ++i)
            if (there[i]) quarter(x + i % 2, y + i / 2, i % 2 ? -0.5 : 0, i / 2 ? -0.5 : 0);
    }

  private:
    bool covered(int x, int y) const { return texture_.coverage.holds(x, y) && texture_.coverage.at(x, y); }

    double along_axis(int x, int y) const {
        return glm::dot(world_point(texture_, x, y) - texture_.camera.corner, forward(texture_.camera));
    }
    double spread(int x, int y) const {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (int i = 0; i < 4; ++i) {
            const double d = along_axis(x + i % 2, y + i / 2);
            low = std::min(low, d), high = std::max(high, d);
        }
        return high - low;
    }

    // The texel's point, or one beside it at the texel's depth.
    Corner corner(int x, int y, double by_u, double by_v) const {
        const double u = x + 0.5 + by_u, v = y + 0.5 + by_v;
        const glm::dvec3 p = texture_.camera.projection == Projection::Orthographic
                                 ? world_point(texture_.camera, u, v, displacement(texture_, x, y))
                                 : world_point(texture_.camera, u, v, disparity(texture_, x, y));
        const glm::dvec3 s = screen_from_world_ * (p - viewer_.eye);  // (x, y, 1) times z
        constexpr double most = 2 * pipeline::max_picture_size;
        const bool seen = s.z > 0 && std::fabs(s.x) <= most * s.z && std::fabs(s.y) <= most * s.z;
        if (!seen) return {{}, {}, false};
        const auto snapped = [](double place) { return static_cast<std::int32_t>(std::lrint(256 * place)); };
        const auto rw = static_cast<Scalar>(1 / (s.z * distance_));
        return {{snapped(s.x / s.z), snapped(s.y / s.z), 0, rw}, texture_.color.at(x, y), true};
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

    const ReliefTexture& texture_;
    const ReliefCamera& viewer_;
    glm::dmat3 screen_from_world_;
    double distance_, jump_;
    std::uint8_t label_;
    Sides sides_;
    ViewImage& into_;
};

}  // namespace view_mesh_detail

// Draws into a picture of the viewer's size what is nearer than what is there. Where it draws, coverage
// becomes `label` (not 0), so that one can see which texture a pixel came from.
inline void draw_view_mesh(const ReliefTexture& texture, const ReliefCamera& viewer, double jump,
                           ViewImage& into, std::uint8_t label = 1, Sides sides = Sides::Front) {
    assert(viewer.projection == Projection::Perspective && label != 0);
    assert(into.width() == viewer.width && into.height() == viewer.height);
    view_mesh_detail::Drawing drawing(texture, viewer, jump, label, sides, into);
    for (int y = -1; y < texture.camera.height; ++y)
        for (int x = -1; x < texture.camera.width; ++x) drawing.cell(x, y);
}

}  // namespace relevo::relief
