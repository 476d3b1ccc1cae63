// Discs and rings: how far their coverage is from the exact area.
#include <cmath>
#include <vector>

#include "raster/curve_coverage.hpp"
#include "tests/accuracy/measurement.hpp"
#include "tests/raster/curve_area.hpp"

namespace relevo::accuracy {
namespace {

using tests::exact_pixel;

constexpr int reach = 70;
constexpr raster::PixelBox picture{-reach, -reach, reach, reach};
constexpr std::size_t side = 2 * reach + 1;

struct Curve {
    glm::dvec2 center;
    double a, b, width;  // 0: filled
};

// Calls see(curve, error of a pixel of full coverage) for every pixel that the edge of a random one touches.
template <class See>
void each_pixel(bool ring, See see) {
    Random random(7);
    for (int i = 0; i < 150; ++i) {
        Curve c{{random.between(-1, 1), random.between(-1, 1)},
                random.of_any_size(0.05, 60),
                random.of_any_size(0.05, 60),
                ring ? random.of_any_size(0.25, 8) : 0};
        if (i % 2) c.b = c.a;
        std::vector<int> covered(side * side);
        const auto at = [](int x, int y) { return std::size_t(y + reach) * side + std::size_t(x + reach); };
        const auto cover = [&](int y, int x0, int x1, int coverage) {
            for (int x = x0; x < x1; ++x) covered[at(x, y)] += coverage;
        };
        if (ring)
            raster::ring_coverage(c.center, c.a, c.b, c.width, picture, cover);
        else
            raster::disc_coverage(c.center, c.a, c.b, picture, cover);
        const double half = c.width / 2;
        const bool hole = ring && c.a > half && c.b > half;
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                auto exact = exact_pixel(c.center, c.a + half, c.b + half, x, y);
                if (hole) exact -= exact_pixel(c.center, c.a - half, c.b - half, x, y);
                const double error = double(covered[at(x, y)]) / raster::full_coverage - double(exact);
                if (error != 0) see(c, error);
            }
    }
}

Measured measure_largest(bool ring) {
    Measured worst;
    each_pixel(ring, [&](const Curve& c, double error) {
        worst.see(std::abs(error), [&] {
            return text("radii %g, %g, width %g around (%g, %g)", c.a, c.b, c.width, c.center.x, c.center.y);
        });
    });
    return worst;
}
Measured measure_rms(bool ring) {
    double squares = 0, count = 0;
    each_pixel(ring, [&](const Curve&, double error) { squares += error * error, count += 1; });
    Measured rms;
    rms.see(std::sqrt(squares / count), [&] { return text("%.0f pixels", count); });
    return rms;
}

constexpr Measurement measurements[] = {
    {"disc, area", [] { return measure_largest(false); }},
    {"disc, area, rms", [] { return measure_rms(false); }},
    {"ring, area", [] { return measure_largest(true); }},
    {"ring, area, rms", [] { return measure_rms(true); }},
};

}  // namespace

std::span<const Measurement> curve_measurements() { return measurements; }

}  // namespace relevo::accuracy
