// A relief panorama: what one sees all round from a place inside a room, on a cylinder round that place, with
// the depth of every texel; so the viewer may leave the axis, and near things move against far ones (ElHelw
// and Yang, "Cylindrical relief texture mapping", 2003; Clua 2004, 3.4.2).
//
//     texel (u, v):  P(u, v) = C + r (cos a ahead + sin a right) + y up      a = 360 u / width degrees
//                    y = high - (high - low) v / height                      X = C + (P - C) / q
//
// q > 0 is the disparity of a perspective source: 1 on the cylinder, less behind it. As with a flat relief
// texture, the picture for another viewer T is made in two steps:
//
//   1  the warp    every texel goes to where the line of sight from T to X meets the cylinder:
//                  T + t (X - T), t > 0, at distance r from the axis; pixel by pixel, all round
//   2  the picture on the cylinder is looked at from T: standard texture mapping
//
// With T = C the first step moves nothing. Done without it, the second shows the room painted flat on the
// cylinder: the panorama without parallax.
//
// Measured in `room` (surface_room.hpp; 1024 columns, views of 192 x 144 pixels; most bad pixels lie on edges
// of its checkers), the viewer 0, 0.1, 0.2 and 0.4 off the axis, the walls 1 and 1.2 away: bad
// pixels 6.9, 11.0, 11.5 and 14.0 %, of these missing 0, 0.7, 1.3 and 3.5 %; without the first
// step 7.1, 14.0, 24.2 and 41.8 %.
#pragma once
#include <array>
#include <cmath>
#include <string>

#include "relief/grid_mesh.hpp"
#include "relief/ray_cast.hpp"
#include "relief/texel_shares.hpp"

namespace relevo::relief {

// The axis goes through `centre` along `up`; column 0 begins in the direction `ahead`, and columns run to the
// right as seen from inside, once round. Lengths in world units.
struct CylinderCamera {
    glm::dvec3 centre{0}, ahead{0, 0, -1}, up{0, 1, 0};  // directions: of length 1, perpendicular
    double radius = 1;                                   // > 0
    double low = -1, high = 1;                           // heights over the centre of the picture's borders
    int width = 0, height = 0;
};

inline std::optional<pipeline::Error> refusal(const CylinderCamera& camera) {
    constexpr int most = pipeline::max_picture_size;
    if (camera.width < 4 || camera.height < 1 || camera.width > most || camera.height > most)
        return pipeline::Error{"a panorama has 4 to " + std::to_string(most) + " columns and 1 to " +
                               std::to_string(most) + " rows, not " + std::to_string(camera.width) + " x " +
                               std::to_string(camera.height)};
    const auto is_unit = [](const glm::dvec3& v) { return std::fabs(glm::dot(v, v) - 1) <= 1e-9; };
    if (!is_finite(camera.centre) || !is_unit(camera.ahead) || !is_unit(camera.up) ||
        !(std::fabs(glm::dot(camera.ahead, camera.up)) <= 1e-9))
        return pipeline::Error{
            "the axes of a panorama must be of length 1 and perpendicular, its centre finite"};
    if (!(camera.radius > 0 && std::isfinite(camera.radius)) || !(camera.low < camera.high) ||
        !std::isfinite(camera.high - camera.low))
        return pipeline::Error{
            "the cylinder of a panorama needs a radius above 0 and low < high, all finite"};
    return {};
}

inline glm::dvec3 cylinder_point(const CylinderCamera& camera, double u, double v) {
    const pipeline::Degrees angle{360 * u / camera.width};
    const glm::dvec3 right = glm::cross(camera.ahead, camera.up);
    const double y = camera.high - (camera.high - camera.low) * v / camera.height;
    return camera.centre +
           (camera.radius * (pipeline::cos(angle) * camera.ahead + pipeline::sin(angle) * right) +
            y * camera.up);
}

// All channels have the camera's size; `depth` is q of the header. Where coverage is 0 the others mean
// nothing.
struct CylinderRelief {
    CylinderCamera camera;
    Image<LinearRgb> color;
    Image<Vec3> normal;
    Image<Scalar> depth;
    Image<std::uint8_t> coverage;
};

inline glm::dvec3 world_point(const CylinderRelief& relief, int x, int y) {
    const glm::dvec3 sight = cylinder_point(relief.camera, x + 0.5, y + 0.5) - relief.camera.centre;
    return relief.camera.centre + sight / double{relief.depth.at(x, y)};
}

// One ray from the centre through the middle of each texel. Errors are those of refusal().
template <RayCastable Surface>
Result<CylinderRelief> capture_cylinder(const Surface& surface, const CylinderCamera& camera) {
    if (auto error = refusal(camera)) return *std::move(error);
    const int width = camera.width, height = camera.height;
    CylinderRelief relief{camera, {width, height}, {width, height}, {width, height}, {width, height}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto hit = first_hit(
                surface, Ray{camera.centre, cylinder_point(camera, x + 0.5, y + 0.5) - camera.centre});
            if (!hit || !(hit->t > 0)) continue;
            relief.color.at(x, y) = hit->color;
            relief.normal.at(x, y) = Vec3(hit->normal);
            relief.depth.at(x, y) = static_cast<Scalar>(1 / hit->t);
            relief.coverage.at(x, y) = 1;
        }
    return relief;
}

// A viewer at T inside of the cylinder.
class CylinderSight {
  public:
    CylinderSight(const CylinderCamera& camera, const glm::dvec3& viewer)
        : camera_(camera), right_(glm::cross(camera.ahead, camera.up)), from_(along(viewer - camera.centre)) {
        const double off = from_.x * from_.x + from_.y * from_.y;
        rest_ = camera.radius * camera.radius - off;
    }
    bool inside() const { return rest_ > 0; }
    double off_axis() const { return std::sqrt(from_.x * from_.x + from_.y * from_.y); }
    double off_axis(const glm::dvec3& point) const {
        const glm::dvec3 p = along(point - camera_.centre);
        return std::sqrt(p.x * p.x + p.y * p.y);
    }

    // Where T + t direction meets the cylinder: u in (-width / 2, width / 2], v, and t > 0. None for a line
    // along the axis.
    struct Met {
        double u, v, t;
    };
    std::optional<Met> meets(const glm::dvec3& direction) const {
        const glm::dvec3 d = along(direction);
        // a t^2 + 2 b t - rest = 0, rest > 0: one root is positive; in the form without cancellation
        const double a = d.x * d.x + d.y * d.y, b = d.x * from_.x + d.y * from_.y;
        const double root = std::sqrt(b * b + a * rest_);
        const double t = b > 0 ? rest_ / (b + root) : (root - b) / a;
        if (!(a > 0 && t > 0 && std::isfinite(t))) return {};
        const glm::dvec3 p = from_ + t * d;
        return Met{pipeline::angle_of(p.x, p.y).value * camera_.width / 360,
                   (camera_.high - p.z) * camera_.height / (camera_.high - camera_.low), t};
    }

  private:
    // Along ahead, right and up.
    glm::dvec3 along(const glm::dvec3& v) const {
        return {glm::dot(v, camera_.ahead), glm::dot(v, right_), glm::dot(v, camera_.up)};
    }
    const CylinderCamera& camera_;
    glm::dvec3 right_, from_;
    double rest_;  // of the viewer's distance from the axis to the cylinder: r^2 - distance^2
};

namespace cylinder_detail {

// The texels in the unrolled picture, moved by whole turns; columns go on beyond both ends.
class Grid {
  public:
    Grid(const CylinderRelief& relief, const CylinderSight& sight, const glm::dvec3& viewer, int turns)
        : relief_(relief), sight_(sight), viewer_(viewer), turns_(turns) {}
    int width() const { return relief_.camera.width; }
    int height() const { return relief_.camera.height; }
    bool covered(int x, int y) const {
        // What is farther from the axis than the viewer moves by less than a quarter turn: of the other turns
        // only the ends can reach the picture.
        const bool reaches = turns_ == 0 || (turns_ < 0 ? 4 * x >= 3 * width() : 4 * x <= width());
        return reaches && y >= 0 && y < height() && relief_.coverage.at(column(x), y);
    }
    LinearRgb color(int x, int y, double, double) const { return relief_.color.at(column(x), y); }
    double depth(int x, int y) const {
        return relief_.camera.radius / double{relief_.depth.at(column(x), y)};
    }
    std::optional<MovedPoint> moved(int x, int y, double by_u, double by_v) const {
        const double u = x + 0.5 + by_u;
        const glm::dvec3 sight = cylinder_point(relief_.camera, u, y + 0.5 + by_v) - relief_.camera.centre,
                         p = relief_.camera.centre + sight / double{relief_.depth.at(column(x), y)};
        const auto met = sight_.meets(p - viewer_);
        if (!met) return {};
        const double turns = std::floor((u - met->u) / width() + 0.5) + turns_;
        return MovedPoint{met->u + turns * width(), met->v, 1 / met->t};
    }

  private:
    int column(int x) const { return (x % width() + width()) % width(); }
    const CylinderRelief& relief_;
    const CylinderSight& sight_;
    const glm::dvec3& viewer_;
    int turns_;
};

}  // namespace cylinder_detail

// Step 1: the picture on the cylinder as a viewer inside must see it; its depth is that of the things in
// distances of the cylinder along the viewer's line of sight. The mesh is cut where neighbours differ by more
// than `jump` in distance from the axis (along the cylinder's radius), world units.
//
// Errors: a viewer on or outside the cylinder, and one that is not nearer to the axis than everything to be
// seen: what he is past is in no panorama.
inline Result<ViewImage> warp_cylinder(const CylinderRelief& relief, const glm::dvec3& viewer,
                                       double jump = 0.1) {
    const CylinderSight sight(relief.camera, viewer);
    if (!sight.inside()) return pipeline::Error{"the viewer of a panorama must stand inside of its cylinder"};
    for (int y = 0; y < relief.camera.height; ++y)
        for (int x = 0; x < relief.camera.width; ++x)
            if (relief.coverage.at(x, y) && !(sight.off_axis(world_point(relief, x, y)) > sight.off_axis()))
                return pipeline::Error{
                    "the viewer of a panorama must stand nearer to its axis than all that is seen"};
    ViewImage warped(relief.camera.width, relief.camera.height);
    for (const int turns : {0, -1, 1})
        draw_grid_mesh(cylinder_detail::Grid(relief, sight, viewer, turns), jump, warped);
    return warped;
}

// The panorama as it was captured: step 2 of it is the panorama without parallax.
inline ViewImage unwarped(const CylinderRelief& relief) {
    ViewImage picture(relief.camera.width, relief.camera.height);
    picture.color = relief.color, picture.coverage = relief.coverage;
    for (std::size_t i = 0; i < picture.depth.pixels().size(); ++i) picture.depth.pixels()[i] = 1;
    return picture;
}

// Step 2: the picture on the cylinder, seen by a perspective camera whose eye is inside of it. A place
// between the pixels is read by texel_shares.hpp, its jump in the picture's depth. Above and below the
// cylinder nothing is covered. Depth is along the viewer's axis.
inline ViewImage look_at_cylinder(const CylinderCamera& camera, const ViewImage& picture,
                                  const ReliefCamera& viewer, Reading reading = Reading::Bilinear,
                                  double jump = 0.1) {
    assert(picture.width() == camera.width && picture.height() == camera.height);
    const CylinderSight sight(camera, viewer.eye);
    assert(sight.inside());
    ViewImage image(viewer.width, viewer.height);
    const auto column = [&](int x) { return x % camera.width; };
    for (int y = 0; y < viewer.height; ++y)
        for (int x = 0; x < viewer.width; ++x) {
            const glm::dvec3 direction = plane_point(viewer, x + 0.5, y + 0.5) - viewer.eye;
            const auto met = sight.meets(direction);
            if (!met) continue;
            // In the second of three turns, so that neighbours across the seam are neighbours.
            const auto shares = texel_shares(
                3 * camera.width, camera.height, met->u + (met->u < 0 ? 2 : 1) * camera.width, met->v,
                reading, jump, [&](int i, int j) { return picture.coverage.at(column(i), j) != 0; },
                [&](int i, int j) { return double{picture.depth.at(column(i), j)}; });
            if (!shares) continue;
            const double times = weighted_sum(*shares, 0.0, [&](int i, int j, double share) {
                return share * double{picture.depth.at(column(i), j)};
            });
            image.coverage.at(x, y) = 1;
            image.color.at(x, y) = weighted_sum(*shares, LinearRgb{}, [&](int i, int j, double share) {
                return static_cast<Scalar>(share) * picture.color.at(column(i), j);
            });
            image.depth.at(x, y) = static_cast<Scalar>(times * met->t * glm::dot(direction, forward(viewer)));
        }
    return image;
}

}  // namespace relevo::relief
