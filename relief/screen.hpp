// Between the machine's camera and frame (raster/scene.hpp) and a viewer's screen and picture
// (view_image.hpp).
#pragma once
#include "raster/scene.hpp"
#include "relief/view_image.hpp"

namespace relevo::relief {

// The screen of a perspective machine camera: its plane is the near plane, its texels are the pixels. An
// error for a parallel view, and for one whose maps have no inverse.
inline Result<ReliefCamera> screen_camera(const raster::Camera& camera, raster::DepthFormat format, int width,
                                          int height) {
    if (camera.parallel) return pipeline::Error{"a parallel view has no eye"};
    const glm::dmat4& p = camera.clip_from_eye.m;
    const glm::dmat4 world_from_eye = glm::inverse(camera.eye_from_world.m);
    // where z / w is that of the near plane: p22 z + p32 = -z, or 0
    const double near =
        format == raster::DepthFormat::Float32Reversed ? p[3][2] / (p[2][2] + 1) : p[3][2] / p[2][2];
    const auto on_plane = [&](double x, double y) {  // in the eye's space, from clip x and y over w
        return glm::dvec3((x + p[2][0]) / p[0][0], (y + p[2][1]) / p[1][1], -1) * near;
    };
    const auto to_world = [&](const glm::dvec3& d) { return glm::dvec3(world_from_eye * glm::dvec4(d, 0)); };
    ReliefCamera screen{Projection::Perspective};
    screen.eye = glm::dvec3(world_from_eye[3]);
    screen.corner = screen.eye + to_world(on_plane(-1, 1));
    screen.a = to_world(on_plane(1, 1) - on_plane(-1, 1)) / double(width);
    screen.b = to_world(on_plane(-1, -1) - on_plane(-1, 1)) / double(height);
    screen.width = width, screen.height = height;
    return screen;
}

// The picture, seen by screen_camera() of the same camera, into the frame: nearer wins, as everywhere.
inline void draw_view_image(const ViewImage& image, const raster::Camera& camera,
                            const raster::Settings& settings, raster::Frame& frame) {
    const glm::dmat4& p = camera.clip_from_eye.m;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            if (!image.coverage.at(x, y)) continue;
            const double depth = double{image.depth.at(x, y)};
            const double clip_z = p[3][2] - p[2][2] * depth;  // clip w is the depth itself
            const auto z = static_cast<Scalar>(clip_z / depth);
            Scalar& stored = frame.depth.at(x, y);
            if (!(depth > 0 && clip_z >= 0 && clip_z <= depth) || !raster::nearer(settings.depth, z, stored))
                continue;
            stored = z;
            const LinearRgb color = image.color.at(x, y);
            frame.color.at(x, y) = raster::to_rgba8(color, settings.output);
            if (!frame.linear.empty()) frame.linear.at(x, y) = color;
        }
}

}  // namespace relevo::relief
