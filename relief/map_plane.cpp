#include "relief/map_plane.hpp"

#include <cmath>

namespace relevo::relief {
namespace {

struct Read {
    bool covered = false;
    LinearRgb color;
    double depth = 0;
};

Read read_nearest(const Prewarped& picture, double u, double v) {
    const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
    if (!picture.coverage.holds(x, y) || !picture.coverage.at(x, y)) return {};
    return {true, picture.color.at(x, y), double{picture.depth.at(x, y)}};
}

Read read_bilinear(const Prewarped& picture, double u, double v, Scalar jump_depth) {
    const int x = static_cast<int>(std::floor(u - 0.5)), y = static_cast<int>(std::floor(v - 0.5));
    const double s = u - 0.5 - x, t = v - 0.5 - y;
    const auto share = [&](int i) { return (i % 2 ? s : 1 - s) * (i / 2 ? t : 1 - t); };
    double covered = 0, heaviest = -1, nearest = 0;
    for (int i = 0; i < 4; ++i) {
        const int px = x + i % 2, py = y + i / 2;
        if (!picture.coverage.holds(px, py) || !picture.coverage.at(px, py)) continue;
        covered += share(i);
        if (share(i) > heaviest) heaviest = share(i), nearest = double{picture.depth.at(px, py)};
    }
    if (!(covered >= 0.5)) return {};
    double sum = 0, depth = 0;
    LinearRgb color{};
    for (int i = 0; i < 4; ++i) {
        const int px = x + i % 2, py = y + i / 2;
        if (!picture.coverage.holds(px, py) || !picture.coverage.at(px, py)) continue;
        const double d = double{picture.depth.at(px, py)};
        if (std::abs(d - nearest) > double{jump_depth}) continue;
        sum += share(i), depth += share(i) * d,
            color = color + static_cast<Scalar>(share(i)) * picture.color.at(px, py);
    }
    return {true, static_cast<Scalar>(1 / sum) * color, depth / sum};
}

}  // namespace

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
            const Read read = reading == Reading::Nearest ? read_nearest(picture, u, v)
                                                          : read_bilinear(picture, u, v, jump_depth);
            if (!read.covered) continue;
            const glm::dvec3 on_plane = plane_point(source, at.x / at.z, at.y / at.z);
            image.coverage.at(x, y) = 1;
            image.color.at(x, y) = read.color;
            image.depth.at(x, y) =
                static_cast<Scalar>(view_depth(screen, on_plane) * (1 + read.depth / warp.h));
        }
    return image;
}

}  // namespace relevo::relief
