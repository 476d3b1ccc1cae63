#include "relief/resample_line.hpp"

namespace relevo::relief {
namespace {

// The depth behind the plane of every texel, in world units; 0 where there is none.
Image<Scalar> depths(const ReliefTexture& texture) {
    Image<Scalar> depth(texture.camera.width, texture.camera.height);
    const bool perspective = texture.camera.projection == Projection::Perspective;
    const double source_h =
        perspective ? glm::dot(texture.camera.corner - texture.camera.eye, forward(texture.camera)) : 0;
    for (std::size_t i = 0; i < depth.pixels().size(); ++i) {
        if (texture.coverage.pixels()[i] == 0) continue;
        const Scalar stored = texture.depth.pixels()[i];
        depth.pixels()[i] =
            perspective ? static_cast<Scalar>(source_h * ((1 - double{stored}) / double{stored})) : stored;
    }
    return depth;
}

}  // namespace

PreparedRelief prepare(const ReliefTexture& texture, Jump jump, Scalar jump_depth) {
    const int width = texture.camera.width, height = texture.camera.height;
    const bool perspective = texture.camera.projection == Projection::Perspective;
    const Image<Scalar> depth = depths(texture);
    const auto covered = [&](int x, int y) {
        return texture.coverage.holds(x, y) && texture.coverage.at(x, y);
    };
    const auto depth_at = [&](int x, int y) { return covered(x, y) ? depth.at(x, y) : 0; };
    const auto between = [&](int x0, int y0, int x1, int y1) {
        return gap_between(covered(x0, y0), covered(x1, y1), depth_at(x0, y0), depth_at(x1, y1), jump,
                           jump_depth);
    };

    PreparedRelief relief{
        texture.camera,      jump,           jump_depth, {}, {width, height}, {width, height},
        {width + 1, height}, {width, height}};
    for (int y = 0; y < height; ++y) {
        raster::Span& span = relief.covered.emplace_back(raster::Span{width, 0});
        for (int x = 0; x <= width; ++x) {
            relief.gap.at(x, y) = between(x - 1, y, x, y);
            if (!covered(x, y)) continue;
            span = {std::min(span.x0, x), x + 1};
            const Scalar here = depth.at(x, y);
            const LinearRgb& c = texture.color.at(x, y);
            const Vec3& n = texture.normal.at(x, y);
            const Scalar slope_v = slope_beyond(between(x, y - 1, x, y), depth_at(x, y - 1),
                                                between(x, y, x, y + 1), depth_at(x, y + 1), here);
            relief.parameter.at(x, y) = perspective ? texture.depth.at(x, y) - 1 : here;
            relief.carried.at(x, y) = {{Four{c.r, c.g, c.b, here}, Four{n.x, n.y, n.z, slope_v}}};
            relief.slope_u.at(x, y) = slope_beyond(between(x - 1, y, x, y), depth_at(x - 1, y),
                                                   between(x, y, x + 1, y), depth_at(x + 1, y), here);
        }
    }
    return relief;
}

}  // namespace relevo::relief
