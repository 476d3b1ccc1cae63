// What the tests of antialiasing share: coverages collected in a grid, and shapes that are hard to cover.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "raster/pixel.hpp"
#include "raster/shape.hpp"

namespace relevo::tests {

using Ring = std::vector<glm::dvec2>;
using Rings = std::vector<Ring>;

// The sink of an algorithm: checks what all of them promise.
class CoverageGrid {
  public:
    explicit CoverageGrid(const raster::PixelBox& pixels)
        : box(pixels),
          width_(pixels.x1 - pixels.x0 + 1),
          cells_(std::size_t(width_) * std::size_t(pixels.y1 - pixels.y0 + 1), 0) {}

    void operator()(int y, int x0, int x1, int coverage) {
        ASSERT_LT(x0, x1);
        ASSERT_TRUE(box.holds(x0, y) && box.holds(x1 - 1, y)) << x0 << ".." << x1 << ", " << y;
        ASSERT_GE(coverage, 1);
        ASSERT_LE(coverage, raster::full_coverage);
        ASSERT_TRUE(std::pair(y, x0) >= next_) << "runs are not in order, or a pixel came twice";
        next_ = {y, x1};
        ++runs;
        for (int x = x0; x < x1; ++x) cells_[index(x, y)] = coverage;
    }
    int at(int x, int y) const { return cells_[index(x, y)]; }
    long long sum() const {
        long long all = 0;
        for (const int c : cells_) all += c;
        return all;
    }
    friend bool operator==(const CoverageGrid& a, const CoverageGrid& b) { return a.cells_ == b.cells_; }

    template <class Visit>
    void each(Visit&& visit) const {
        for (int y = box.y0; y <= box.y1; ++y)
            for (int x = box.x0; x <= box.x1; ++x) visit(x, y, at(x, y));
    }

    raster::PixelBox box;
    int runs = 0;

  private:
    std::size_t index(int x, int y) const {
        return std::size_t(y - box.y0) * std::size_t(width_) + std::size_t(x - box.x0);
    }
    int width_;
    std::vector<int> cells_;
    std::pair<int, int> next_{-1000000, -1000000};
};

class RandomPlaces {
  public:
    explicit RandomPlaces(std::uint64_t seed) : bits_(seed) {}
    double between(double low, double high) { return low + (high - low) * (double(bits_() >> 11) * 0x1p-53); }
    int whole(int low, int high) { return low + int(bits_() % std::uint64_t(high - low + 1)); }
    // A multiple of 1/65536, or of a coarser step.
    double place(double low, double high, double step = 0x1p-16) {
        return std::floor(between(low, high) / step) * step;
    }
    glm::dvec2 point(double low, double high, double step = 0x1p-16) {
        const double x = place(low, high, step);
        return {x, place(low, high, step)};
    }

  private:
    std::mt19937_64 bits_;
};

inline constexpr const char* triangle_families[] = {
    "any", "tiny", "sliver", "pixel corners", "pixel halves", "near horizontal", "near vertical", "huge"};

// Corners around pixels 0..9; those of the huge ones are as far away as can be.
inline Ring hard_triangle(std::size_t family, RandomPlaces& random) {
    Ring t{random.point(-2, 11), random.point(-2, 11), random.point(-2, 11)};
    const glm::dvec2 at = random.point(1, 8);
    const double bit = 0x1p-16;
    switch (family) {
        case 1:
            for (glm::dvec2& p : t) p = at + random.point(0, 1.2);
            break;
        case 2: {  // 1/8 pixel thick
            const glm::dvec2 along = t[1] - t[0];
            const double length = std::max(1e-3, std::sqrt(along.x * along.x + along.y * along.y));
            t[2] = t[1] + glm::dvec2{std::floor(-along.y / length * 8192) * bit,
                                     std::floor(along.x / length * 8192) * bit};
            break;
        }
        case 3:
            for (glm::dvec2& p : t) p = random.point(-2, 11, 1) + 0.5;
            break;
        case 4:
            for (glm::dvec2& p : t) p = random.point(-2, 11, 0.5);
            break;
        case 5:
            t[1].y = t[0].y + random.whole(-3, 3) * bit;
            if (random.whole(0, 1)) t[2].y = t[0].y + random.whole(-3, 3) * bit;
            break;
        case 6:
            t[1].x = t[0].x + random.whole(-3, 3) * bit;
            if (random.whole(0, 1)) t[2].x = t[0].x + random.whole(-3, 3) * bit;
            break;
        case 7:
            for (int i = random.whole(0, 2), n = random.whole(1, 3); n > 0; --n, i = (i + 1) % 3)
                t[std::size_t(i)] = random.point(-65534, 65534);
            break;
    }
    return t;
}

// The square of side `size` at (x0, y0) cut into triangles whose corners are shaken out of a grid, but for
// those on the border. Exact on 1/65536 pixel.
inline Rings shaken_mesh(double x0, double y0, int cells, double size, RandomPlaces& random) {
    std::vector<glm::dvec2> p;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            glm::dvec2 c{x0 + i * size, y0 + j * size};
            if (0 < i && i < cells) c.x += random.place(-0.49 * size, 0.49 * size);
            if (0 < j && j < cells) c.y += random.place(-0.49 * size, 0.49 * size);
            p.push_back(c);
        }
    Rings triangles;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const auto at = [&](int di, int dj) { return p[std::size_t((j + dj) * (cells + 1) + i + di)]; };
            // the diagonal that lies inside: both its triangles turn the same way
            const auto turn = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
                return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            };
            if (turn(at(0, 0), at(1, 0), at(1, 1)) > 0 && turn(at(0, 0), at(1, 1), at(0, 1)) > 0) {
                triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
                triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
            } else {
                triangles.push_back({at(0, 0), at(1, 0), at(0, 1)});
                triangles.push_back({at(1, 0), at(1, 1), at(0, 1)});
            }
        }
    return triangles;
}

}  // namespace relevo::tests
