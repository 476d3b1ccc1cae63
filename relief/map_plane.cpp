#include "relief/map_plane.hpp"

namespace relevo::relief {

ViewImage map_plane(const Prewarped& picture, const ReliefCamera& source, const Warp& warp,
                    const ReliefCamera& screen, Reading reading, Scalar jump_depth) {
    ViewImage image(screen.width, screen.height);
    const glm::dmat3 plane_from_screen = glm::inverse(plane_homography(source, screen));
    for (int y = 0; y < screen.height; ++y)
        for (int x = 0; x < screen.width; ++x) {
            // z: how far the pixel's point on the screen's plane is, in distances of the source's plane
            const glm::dvec3 at = plane_from_screen * glm::dvec3(x + 0.5, y + 0.5, 1);
            if (!(at.z > 0)) continue;  // the line of sight leaves the plane behind the viewer
            const double u = at.x / at.z - picture.window.x0, v = at.y / at.z - picture.window.y0;
            if (!(u >= 0 && v >= 0 && u < picture.window.width && v < picture.window.height)) continue;
            const auto shares = texel_shares(
                picture.window.width, picture.window.height, u, v, reading, double{jump_depth},
                [&](int i, int j) { return picture.coverage.at(i, j) != 0; },
                [&](int i, int j) { return double{picture.depth.at(i, j)}; });
            if (!shares) continue;
            const double depth = weighted_sum(*shares, 0.0, [&](int i, int j, double share) {
                return share * double{picture.depth.at(i, j)};
            });
            const glm::dvec3 on_plane = plane_point(source, at.x / at.z, at.y / at.z);
            image.coverage.at(x, y) = 1;
            image.color.at(x, y) = weighted_sum(*shares, LinearRgb{}, [&](int i, int j, double share) {
                return static_cast<Scalar>(share) * picture.color.at(i, j);
            });
            image.depth.at(x, y) = static_cast<Scalar>(view_depth(screen, on_plane) * (1 + depth / warp.h));
        }
    return image;
}

}  // namespace relevo::relief
