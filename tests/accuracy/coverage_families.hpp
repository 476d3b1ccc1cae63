// The shapes with which forms of antialiasing are compared (the columns of coverage_table_test.cpp): one
// straight edge through a pixel, one within 3 degrees of level, slivers of 1/8 pixel, triangles in 2 pixels.
#pragma once
#include <glm/vec2.hpp>
#include <vector>

#include "pipeline/elementary.hpp"
#include "raster/supersample.hpp"
#include "tests/accuracy/measurement.hpp"

namespace relevo::accuracy {

using Ring = std::vector<glm::dvec2>;

enum class CoverageFamily { LongEdge, NearlyLevel, Sliver, Tiny };

// In and around pixels 0..15; corners lie on 1/256 pixel, where samples know them exactly.
inline constexpr raster::PixelBox family_box{0, 0, 15, 15};
inline Ring shape_of(CoverageFamily family, Random& random) {
    const auto on_grid = [](double c) { return std::floor(c * 256 + 0.5) / 256; };
    const auto point = [&](double x, double y) { return glm::dvec2{on_grid(x), on_grid(y)}; };
    const double x = random.between(4, 12), y = random.between(4, 12);
    if (family == CoverageFamily::Tiny) {
        Ring ring;
        for (int i = 0; i < 3; ++i) {
            const double dx = random.between(0, 2);
            ring.push_back(point(x + dx, y + random.between(0, 2)));
        }
        return ring;
    }
    const bool level = family == CoverageFamily::NearlyLevel;
    const pipeline::Degrees angle{level ? random.between(-3, 3) : random.between(0, 360)};
    const double dx = pipeline::cos(angle), dy = pipeline::sin(angle), far = 2000;
    const double thick = family == CoverageFamily::Sliver ? 0.125 : far;
    return {point(x - far * dx, y - far * dy), point(x + far * dx, y + far * dy),
            point(x + far * dx - thick * dy, y + far * dy + thick * dx),
            point(x - far * dx - thick * dy, y - far * dy + thick * dx)};
}

struct CoverageErrors {
    Measured largest{};
    double rms = 0;     // over the pixels that the border of the shape crosses
    double missed = 0;  // of those that hold 1 % of a pixel or more, the share that got nothing
};

// `draw(rings, cover)` against the exact covered area (to 2^-16: raster/area_coverage.hpp).
template <class Draw>
CoverageErrors against_area(CoverageFamily family, int shapes, Draw&& draw) {
    Random random(31);
    CoverageErrors errors;
    double squares = 0, pixels = 0, held = 0, missed = 0;
    for (int i = 0; i < shapes; ++i) {
        const std::vector<Ring> rings{shape_of(family, random)};
        int right[16][16] = {}, ours[16][16] = {};
        const auto into = [](int(&grid)[16][16]) {
            return [&grid](int y, int x0, int x1, int coverage) {
                std::fill(grid[y] + x0, grid[y] + x1, coverage);
            };
        };
        raster::area_coverage(rings, raster::InsideRule::NonZero, family_box, into(right));
        draw(rings, into(ours));
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                if (right[y][x] == 0 || right[y][x] == raster::full_coverage) continue;
                const double off = (ours[y][x] - right[y][x]) / 65536.0;
                squares += off * off, ++pixels;
                if (right[y][x] >= raster::full_coverage / 100) ++held, missed += ours[y][x] == 0;
                errors.largest.see(std::abs(off), [&] {
                    return text("%.4f for %.4f in pixel (%d, %d) of shape %d", ours[y][x] / 65536.0,
                                right[y][x] / 65536.0, x, y, i);
                });
            }
    }
    errors.rms = std::sqrt(squares / pixels), errors.missed = missed / held;
    return errors;
}

inline auto samples(int n) {
    return [n](const std::vector<Ring>& rings, auto cover) {
        raster::supersample(n, rings, raster::InsideRule::NonZero, family_box, cover);
    };
}

}  // namespace relevo::accuracy
