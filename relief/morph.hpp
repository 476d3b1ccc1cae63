// Plain morphing of two views (Wolberg, "Digital image warping", 1990; Clua 2004, 2.4.2, equation 2-2): every
// pixel wanders in a straight line from its place in the one picture to its place in the other, while the
// colours fade over.
//
//     W0(p0, s) = (1 - s) p0 + s C0(p0)        C0: where view 1 shows what view 0 shows at p0
//     W1(p1, s) = (1 - s) C1(p1) + s p1        0 <= s <= 1
//
// Between, the picture is no view of the object: a straight edge bends (fig. 2.6), since the mean of two
// perspective pictures is no perspective picture. view_morph.hpp repairs that.
//
// Who says which pixels belong together? An author, by hand; the pictures themselves (optical_flow.hpp); or,
// for views of our own objects, the object: each texel knows its surface point, which plays the part of the
// vertices' identities in the thesis.
#pragma once
#include "relief/grid_mesh.hpp"
#include "relief/warp_3d.hpp"

namespace relevo::relief {

using pipeline::Vec2;

// What the pixels of one view are in the other. Where `known` is 0 the others mean nothing.
struct Correspondence {
    Image<Vec2> place;    // in pixels of the other view, whether inside of it or not
    Image<Scalar> depth;  // how deep it lies there, > 0; all equal when nobody knows
    Image<std::uint8_t> known;
};

// By the surface points: `view` is a perspective relief texture, which is known for all of its covered texels
// but those behind the other eye. What something else hides in the other view has its place there, too.
inline Correspondence true_correspondence(const ReliefTexture& view, const ReliefCamera& other) {
    const int width = view.camera.width, height = view.camera.height;
    Correspondence c{{width, height, Vec2(0)}, {width, height}, {width, height}};
    const double distance = view_depth(other, other.corner);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!view.coverage.at(x, y)) continue;
            const Warped3d there = warp_3d(view.camera, x + 0.5, y + 0.5, disparity(view, x, y), other);
            if (!(there.z > 0)) continue;
            c.place.at(x, y) = Vec2(there.u, there.v);
            c.depth.at(x, y) = static_cast<Scalar>(there.z * distance);
            c.known.at(x, y) = 1;
        }
    return c;
}

namespace morph_detail {

// One view on its way: move(here, there, depth here, depth there) gives where a point goes that this view
// shows at `here` and the other one at `there`.
template <class Move>
class Grid {
  public:
    Grid(const ViewImage& view, const Correspondence& to, const Move& move)
        : view_(view), to_(to), move_(move) {}
    int width() const { return view_.width(); }
    int height() const { return view_.height(); }
    bool covered(int x, int y) const {
        return view_.coverage.holds(x, y) && view_.coverage.at(x, y) && to_.known.at(x, y);
    }
    LinearRgb color(int x, int y, double, double) const { return view_.color.at(x, y); }
    double depth(int x, int y) const { return double{view_.depth.at(x, y)}; }
    std::optional<MovedPoint> moved(int x, int y, double by_u, double by_v) const {
        const glm::dvec2 here(x + 0.5, y + 0.5), there(to_.place.at(x, y)), by(by_u, by_v);
        return move_(here + by, there + by, depth(x, y), double{to_.depth.at(x, y)});
    }

  private:
    const ViewImage& view_;
    const Correspondence& to_;
    const Move& move_;
};

// Both views moved, then faded into one another: where both are seen and their depths differ by more than
// `jump`, the nearer one alone; where only one is, that one.
template <class Move0, class Move1>
ViewImage faded(const ViewImage& view0, const ViewImage& view1, const Correspondence& to1,
                const Correspondence& to0, double s, double jump, const Move0& move0, const Move1& move1) {
    const int width = view0.width(), height = view0.height();
    ViewImage moved0(width, height), moved1(width, height);
    if (s < 1) draw_grid_mesh(Grid(view0, to1, move0), jump, moved0, 1, Sides::Both);
    if (s > 0) draw_grid_mesh(Grid(view1, to0, move1), jump, moved1, 1, Sides::Both);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!moved1.coverage.at(x, y)) continue;
            Scalar &depth = moved0.depth.at(x, y), other = moved1.depth.at(x, y);
            LinearRgb& color = moved0.color.at(x, y);
            const bool alone = !moved0.coverage.at(x, y);
            const double ahead = double{depth} - double{other};
            if (!alone && ahead < -jump) continue;
            const Scalar share = alone || ahead > jump ? 1 : static_cast<Scalar>(s);
            color = (1 - share) * color + share * moved1.color.at(x, y);
            depth = (1 - share) * depth + share * other;
            moved0.coverage.at(x, y) = 1;
        }
    return moved0;
}

}  // namespace morph_detail

// The picture at s in [0, 1]; 0 is view 0, 1 is view 1. Both have the same size. `jump`, in the depth's
// units, cuts the mesh between neighbouring pixels and tells the views' surfaces apart.
inline ViewImage morph(const ViewImage& view0, const ViewImage& view1, const Correspondence& to1,
                       const Correspondence& to0, double s, double jump) {
    assert(view0.width() == view1.width() && view0.height() == view1.height());
    assert(0 <= s && s <= 1);
    const auto moved_by = [](double share) {
        return [share](const glm::dvec2& here, const glm::dvec2& there, double depth_here,
                       double depth_there) {
            const glm::dvec2 p = (1 - share) * here + share * there;
            return std::optional(MovedPoint{p.x, p.y, 1 / ((1 - share) / depth_here + share / depth_there)});
        };
    };
    return morph_detail::faded(view0, view1, to1, to0, s, jump, moved_by(s), moved_by(1 - s));
}

}  // namespace relevo::relief
