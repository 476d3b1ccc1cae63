// What a viewer gets of an object: colour, depth and coverage of every pixel.
//
// A viewer's screen is the plane of a perspective ReliefCamera, its texels are the pixels: what captures a
// relief texture also draws the truth that a warped one is compared with.
#pragma once
#include "relief/relief_texture.hpp"

namespace relevo::relief {

// Three pictures of one size. Where coverage is 0 nothing was seen, and colour and depth mean nothing.
struct ViewImage {
    Image<LinearRgb> color;
    Image<Scalar> depth;  // world units from the viewer's eye, along its axis
    Image<std::uint8_t> coverage;

    ViewImage() = default;
    ViewImage(int width, int height) : color(width, height), depth(width, height), coverage(width, height) {}
    int width() const { return coverage.width(); }
    int height() const { return coverage.height(); }
};

// How far a point lies from the viewer's eye, along its axis.
inline double view_depth(const ReliefCamera& viewer, const glm::dvec3& p) {
    return glm::dot(p - viewer.eye, forward(viewer));
}

// A perspective relief texture as its own viewer sees it: depth = distance of the plane / disparity.
inline ViewImage as_seen(const ReliefTexture& texture) {
    assert(texture.camera.projection == Projection::Perspective);
    const double distance = view_depth(texture.camera, texture.camera.corner);
    ViewImage image(texture.camera.width, texture.camera.height);
    image.color = texture.color, image.coverage = texture.coverage;
    for (std::size_t i = 0; i < image.depth.pixels().size(); ++i)
        if (image.coverage.pixels()[i])
            image.depth.pixels()[i] = static_cast<Scalar>(distance / double{texture.depth.pixels()[i]});
    return image;
}

// The same plane with `times` x `times` texels in the place of each.
inline ReliefCamera refined(const ReliefCamera& camera, int times) {
    ReliefCamera fine = camera;
    fine.a /= double(times), fine.b /= double(times);
    fine.width *= times, fine.height *= times;
    return fine;
}

// A picture of several samples a pixel, made of one that is `times` as wide and high: a pixel is covered when
// at least half of its samples are; its colour and depth are the mean over the covered ones.
inline ViewImage reduced(const ViewImage& fine, int times) {
    ViewImage image(fine.width() / times, fine.height() / times);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            glm::dvec3 color{0};
            double depth = 0;
            int covered = 0;
            for (int j = y * times; j < (y + 1) * times; ++j)
                for (int i = x * times; i < (x + 1) * times; ++i) {
                    if (!fine.coverage.at(i, j)) continue;
                    const LinearRgb c = fine.color.at(i, j);
                    ++covered, color += glm::dvec3(c.r, c.g, c.b), depth += double{fine.depth.at(i, j)};
                }
            if (covered == 0 || 2 * covered < times * times) continue;
            color /= covered;
            image.color.at(x, y) = {Scalar(color.x), Scalar(color.y), Scalar(color.z)};
            image.depth.at(x, y) = static_cast<Scalar>(depth / covered);
            image.coverage.at(x, y) = 1;
        }
    return image;
}

}  // namespace relevo::relief
