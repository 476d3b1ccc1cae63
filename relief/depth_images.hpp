// An object as relief textures placed at any angles: the box of six faces (box.hpp) set free (the
// "generalised box" of Bayakovski, Levkovich-Maslyuk et al., "Depth image-based representation for static and
// animated 3D objects", 2002; Clua 2004, 3.2).
//
// The six sides of a box are as good as any for a ball. A bowl that is tilted shows its inside to none of
// them whole; a picture taken straight into it does. So the sources stand where there is something to be
// seen, each on a plane of its own that touches the object's bounding ball; what they show is drawn by depth,
// the nearest point of all of them winning, as for the box.
//
// Measured on a tilted bowl (160 x 160 texels), from seven sides on which its inside is in view: six faces
// miss 20.5 % of it in the mean, the eight pictures from a box's corners 5.2 %.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "relief/capture.hpp"
#include "relief/view_mesh.hpp"

namespace relevo::relief {

// The object's bounding ball.
struct Ball {
    glm::dvec3 centre;
    double radius;  // > 0
};

// The camera that looks at the ball from `direction` (from its centre; any length but zero): orthographic,
// size x size texels that hold the ball, its plane touches the ball. Errors are those of orthographic_camera.
inline Result<ReliefCamera> camera_from(const Ball& ball, const glm::dvec3& direction, int size) {
    const double length = std::sqrt(glm::dot(direction, direction));
    if (!(length > 0) || !std::isfinite(length))
        return pipeline::Error{"a depth image needs a direction to look from"};
    const glm::dvec3 from = direction / length;
    // Upright, unless that is where it looks from.
    const glm::dvec3 up = std::fabs(from.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -from.y);
    return orthographic_camera({-from, up, size, size}, ball.centre + ball.radius * from, 2 * ball.radius);
}

// The eight directions between three axes: where the corners of a box are.
inline constexpr std::array<std::array<double, 3>, 8> corner_directions = {
    {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}}};

// One relief texture a direction. At most 255. Errors are those of camera_from and of the capture.
template <Capture C>
Result<std::vector<ReliefTexture>> capture_depth_images(const C& capture, const Ball& ball,
                                                        std::span<const glm::dvec3> directions, int size) {
    if (directions.size() > 255) return pipeline::Error{"at most 255 depth images are drawn together"};
    std::vector<ReliefTexture> images;
    for (const glm::dvec3& direction : directions) {
        const auto camera = camera_from(ball, direction, size);
        if (!camera) return camera.error();
        auto texture = capture(*camera);
        if (!texture) return texture.error();
        images.push_back(*std::move(texture));
    }
    return images;
}

// The picture of a perspective viewer; the coverage of a pixel is 1 + the number of the image that it came
// from. `jump` is that of view_mesh.hpp.
inline ViewImage draw_depth_images(std::span<const ReliefTexture> images, const ReliefCamera& viewer,
                                   double jump = 0.1) {
    assert(images.size() <= 255);
    ViewImage into(viewer.width, viewer.height);
    for (std::size_t i = 0; i < images.size(); ++i)
        draw_view_mesh(images[i], viewer, jump, into, static_cast<std::uint8_t>(1 + i));
    return into;
}

}  // namespace relevo::relief
