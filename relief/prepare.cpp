#include <limits>

#include "relief/resample_line.hpp"

namespace relevo::relief {
namespace {

constexpr Scalar infinity = std::numeric_limits<Scalar>::infinity();

// The depth behind the plane of every texel, in world units; 0 where there is none.
Image<Scalar> depths(const ReliefTexture& texture) {
    Image<Scalar> depth(texture.camera.width, texture.camera.height);
    const bool perspective = texture.camera.projection == Projection::Perspective;
    const double source_h = height_of_source(texture.camera);
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

    // A line of texels that leads inwards from (x, y), where the surface ends.
    struct Inwards {
        int x, y, step_x, step_y;
        int x_at(int k) const { return x + k * step_x; }
        int y_at(int k) const { return y + k * step_y; }
    };
    const auto gap = [&](const Inwards& in, int k) {  // between its texels k and k + 1
        return between(in.x_at(k), in.y_at(k), in.x_at(k + 1), in.y_at(k + 1));
    };
    const auto ends_here = [&](const Inwards& in) {
        return covered(in.x, in.y) && sticks_out(gap(in, -1)) && !sticks_out(gap(in, 0));
    };
    // How deep the surface is where it ends, as far as this line can tell.
    const auto end_depth = [&](const Inwards& in) -> Scalar {
        const auto at = [&](int k) { return depth_at(in.x_at(k), in.y_at(k)); };
        if (gap(in, 0) == Gap::Across) return at(0);  // steeper than can be continued
        const auto second = gap(in, 1) == Gap::Joined ? std::optional(at(2)) : std::nullopt;
        return at(0) + growth_beyond(at(0), at(1), second);
    };
    // How much deeper the surface gets beyond the last texel of the line: to the deepest end of the lines
    // beside it that belong to the same outline.
    const auto growth = [&](const Inwards& in) -> Scalar {
        constexpr int lines = 2, texels = 4;  // how far away they may be, and how much longer or shorter
        const Scalar here = depth.at(in.x, in.y), most = 2 * (here - depth_at(in.x_at(1), in.y_at(1)));
        if (!(most > 0)) return 0;
        Scalar deepest = end_depth(in);
        for (int line = -lines; line <= lines; ++line)
            for (int texel = -texels; texel <= texels; ++texel) {
                const Inwards beside{in.x_at(texel) + line * in.step_y, in.y_at(texel) + line * in.step_x,
                                     in.step_x, in.step_y};
                if (line == 0 || !ends_here(beside)) continue;
                if (std::abs(depth.at(beside.x, beside.y) - here) <= std::max(jump_depth, most))
                    deepest = std::max(deepest, end_depth(beside));
            }
        return std::clamp(deepest - here, Scalar(0), most);
    };
    // Beyond (x, y) along u or v, whichever side the surface ends on; 0 where it ends on both or on none.
    const auto growth_along = [&](int x, int y, int step_x, int step_y) -> Scalar {
        for (const int side : {-1, 1})
            if (const Inwards in{x, y, side * step_x, side * step_y}; ends_here(in)) return growth(in);
        return 0;
    };

    using Parameters = PreparedRelief::Parameters;
    const int blocks_in_row = (width + block_width - 1) / block_width,
              rows_of_blocks = (height + block_height - 1) / block_height;
    PreparedRelief relief{texture.camera,
                          jump,
                          jump_depth,
                          {},
                          {width, height},
                          {width, height},
                          {width + 1, height},
                          {width, height},
                          {blocks_in_row, rows_of_blocks, Parameters{infinity, -infinity}}};
    const Scalar inverse_source_h = static_cast<Scalar>(1 / height_of_source(texture.camera));
    for (int y = 0; y < height; ++y) {
        raster::Span& span = relief.covered.emplace_back(raster::Span{width, 0});
        for (int x = 0; x <= width; ++x) {
            relief.gap.at(x, y) = between(x - 1, y, x, y);
            if (!covered(x, y)) continue;
            span = {std::min(span.x0, x), x + 1};
            const Scalar here = depth.at(x, y);
            const LinearRgb& c = texture.color.at(x, y);
            const Vec3& n = texture.normal.at(x, y);
            const Scalar growth_v = growth_along(x, y, 0, 1);
            relief.parameter.at(x, y) = perspective ? texture.depth.at(x, y) - 1 : here;
            relief.carried.at(x, y) = {{Four{c.r, c.g, c.b, here}, Four{n.x, n.y, n.z, growth_v}}};
            const Scalar growth_u = relief.growth_u.at(x, y) = growth_along(x, y, 1, 0);
            auto& [least, largest] = relief.parameters.at(x / block_width, y / block_height);
            for (const Scalar q :
                 {relief.parameter.at(x, y), parameter_at(depth_beyond(here, growth_u), inverse_source_h)}) {
                least = std::min(least, std::isfinite(q) ? q : -infinity);
                largest = std::max(largest, std::isfinite(q) ? q : infinity);
            }
        }
    }
    return relief;
}

}  // namespace relevo::relief
