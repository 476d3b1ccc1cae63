// A relief texture drawn straight to a viewer's screen, as the mesh of triangles between its texels, with a
// z-buffer: every texel by McMillan's 3-D warp (warp_3d.hpp), none by way of a plane.
//
// So it needs no plane in front of the viewer, and the textures of many planes can be drawn into one picture,
// the nearest point of all of them winning: the faces of a box, or depth images placed at any angle.
//
// The mesh is cut where the depths of neighbours differ by more than `jump` (world units along f). What a
// texel shows is one side of the surface: triangles that turn their back to the viewer, seen from where the
// source is not, are drawn only when the texture holds surfaces of both sides.
#pragma once
#include "relief/grid_mesh.hpp"
#include "relief/warp_3d.hpp"

namespace relevo::relief {

namespace view_mesh_detail {

class Grid {
  public:
    Grid(const ReliefTexture& texture, const ReliefCamera& viewer)
        : texture_(texture),
          viewer_(viewer),
          screen_from_world_(glm::inverse(sight_matrix(viewer))),
          distance_(view_depth(viewer, viewer.corner)) {}

    int width() const { return texture_.camera.width; }
    int height() const { return texture_.camera.height; }
    bool covered(int x, int y) const { return texture_.coverage.holds(x, y) && texture_.coverage.at(x, y); }
    LinearRgb color(int x, int y, double, double) const { return texture_.color.at(x, y); }
    double depth(int x, int y) const {
        return glm::dot(world_point(texture_, x, y) - texture_.camera.corner, forward(texture_.camera));
    }
    std::optional<MovedPoint> moved(int x, int y, double by_u, double by_v) const {
        return moved(x + 0.5 + by_u, y + 0.5 + by_v, texture_.depth.at(x, y));
    }
    // The point at (u, v) of the texture's plane, with a displacement or disparity of its own.
    std::optional<MovedPoint> moved(double u, double v, Scalar depth) const {
        const ReliefCamera& camera = texture_.camera;
        const glm::dvec3 p = camera.projection == Projection::Orthographic
                                 ? world_point(camera, u, v, Displacement{depth})
                                 : world_point(camera, u, v, Disparity{depth});
        const glm::dvec3 s = screen_from_world_ * (p - viewer_.eye);  // (x, y, 1) times z
        if (!(s.z > 0)) return {};
        return MovedPoint{s.x / s.z, s.y / s.z, s.z * distance_};
    }

  private:
    const ReliefTexture& texture_;
    const ReliefCamera& viewer_;
    glm::dmat3 screen_from_world_;
    double distance_;
};

}  // namespace view_mesh_detail

// Draws into a picture of the viewer's size what is nearer than what is there. Where it draws, coverage
// becomes `label` (not 0), so that one can see which texture a pixel came from.
inline void draw_view_mesh(const ReliefTexture& texture, const ReliefCamera& viewer, double jump,
                           ViewImage& into, std::uint8_t label = 1, Sides sides = Sides::Front) {
    assert(viewer.projection == Projection::Perspective);
    assert(into.width() == viewer.width && into.height() == viewer.height);
    draw_grid_mesh(view_mesh_detail::Grid(texture, viewer), jump, into, label, sides);
}

}  // namespace relevo::relief
