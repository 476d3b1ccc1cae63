// A straight edge that runs across a step of depth must stay straight: what the resamplers are judged by
// (Clua 2004, 8.2). The skin between the two depths shows the bend; between neighbours of a smooth
// surface it is too small to be seen.
#include <gtest/gtest.h>

#include <map>

#include "relief/prewarp.hpp"

namespace relevo::relief {
namespace {

constexpr int width = 64, height = 304, step_at = 32, edge = 296;  // the edge: between rows 295 and 296
constexpr double h = 2, epipole_u = 500, epipole_v = 1;            // 295 texels from the edge

// How far from the straight line the edge is drawn at most, in texels, between the two depths 0 and
// `step`.
double bend(Resampler resampler, double step) {
    const ReliefCamera camera =
        *orthographic_camera({{0, 0, -1}, {0, 1, 0}, width, height}, {0, 0, 0}, height / 64.0);
    ReliefTexture texture = make_relief_texture(camera);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            texture.coverage.at(x, y) = 1;
            texture.depth.at(x, y) = x < step_at ? 0 : static_cast<Scalar>(step);
        }
    const Warp warp =
        *make_warp(camera, viewer_at(plane_point(camera, epipole_u, epipole_v) + glm::dvec3(0, 0, h)));
    const Window window = *target_window(camera, warp, depth_range(texture));
    PrewarpSettings settings;
    settings.resampler = resampler, settings.maps = true;
    const Prewarped got = prewarp(texture, warp, window, settings);

    const WarpedPoint from = warp_point(warp, step_at - 0.5, edge, Displacement{0}),
                      to = warp_point(warp, step_at + 0.5, edge, Displacement{Scalar(step)});
    double most = 0;
    int columns = 0;
    for (int x = 0; x < window.width; ++x) {
        const double u = x + window.x0 + 0.5, t = (u - from.u) / (to.u - from.u);
        if (t < 0 || t > 1) continue;
        ++columns;
        for (int y = 0; y + 1 < window.height; ++y) {  // where the source's row passes `edge`
            if (!got.coverage.at(x, y) || !got.coverage.at(x, y + 1)) continue;
            const double above = double(got.source.at(x, y).y), below = double(got.source.at(x, y + 1).y);
            if (above > edge || below <= edge) continue;
            const double v = y + window.y0 + 0.5 + (edge - above) / (below - above);
            most = std::max(most, std::abs(v - (from.v + t * (to.v - from.v))));
        }
    }
    EXPECT_GT(columns, 15);
    return most;
}

TEST(StraightEdge, OnlyTheOneDimensionalResamplerBendsIt) {
    // 295 times the most that h / (h + d) differs from the straight line between its ends
    const std::map<double, double> right{{0.1, 0.17}, {0.5, 3.3}, {1, 9.9}, {2, 25.3}};
    for (const auto& [step, expected] : right) {
        const double one = bend(Resampler::OneDimensional, step);
        std::printf("step %.1f: one-dimensional %.2f", step, one);
        EXPECT_NEAR(one, expected, 0.02 * expected + 0.02) << step;
        for (const Resampler resampler :
             {Resampler::Asymmetric, Resampler::Compensated, Resampler::Interleaved, Resampler::Mesh}) {
            const double other = bend(resampler, step);
            std::printf(", %.3f", other);
            EXPECT_LE(other, 0.1) << step << ' ' << static_cast<int>(resampler);
        }
        std::printf(" texels\n");
    }
}

}  // namespace
}  // namespace relevo::relief
