// Lines: what the DDA loses to rounding, and how far the lines of Wu and of Gupta and Sproull are from what
// they approximate, the exact area and the exact volume of the cone over the line's rectangle.
#include <algorithm>
#include <map>
#include <vector>

#include "raster/cone_table.hpp"
#include "raster/line_dda.hpp"
#include "raster/line_gupta_sproull.hpp"
#include "raster/line_midpoint.hpp"
#include "raster/line_outline.hpp"
#include "raster/line_wu.hpp"
#include "tests/accuracy/measurement.hpp"
#include "tests/raster/cone_integral.hpp"

namespace relevo::accuracy {
namespace {

using raster::Pixel;
using Ring = std::vector<glm::dvec2>;

constexpr raster::PixelBox picture{-2000, -2000, 2000, 2000};

struct Sums {
    const raster::LineWalk walk;
    std::vector<int> rows{};
    Measured off{};
    void on(const raster::DdaStep& e) {
        const double start = walk.steep ? walk.from.x : walk.from.y;
        const double exact = start + walk.side * double(e.step) * double(walk.minor) / double(walk.major);
        off.see(std::abs(double(e.across) - exact), [&] {
            return text("step %d of (%d, %d) to (%d, %d)", int(e.step), walk.from.x, walk.from.y, walk.to.x,
                        walk.to.y);
        });
    }
};

// Calls see(line, the sums of its DDA, its pixels that differ, all its pixels).
template <class See>
void each_dda(See see) {
    Random random(1);
    for (int i = 0; i < 4000; ++i) {
        const Pixel a{random.whole(0, 1023), random.whole(0, 1023)},
            b{random.whole(0, 1023), random.whole(0, 1023)};
        Sums sums{raster::line_walk(a, b)};
        std::vector<Pixel> right, ours;
        raster::line_midpoint(a, b, picture, [&](int x, int y) { right.push_back({x, y}); });
        raster::line_dda(
            a, b, picture,
            [&](int x, int y) {
                ours.push_back({x, y});
            },
            sums);
        std::size_t different = 0;
        for (std::size_t k = 0; k < right.size(); ++k) different += ours[k] == right[k] ? 0 : 1;
        see(sums, different, right.size());
    }
}

Measured measure_dda() {
    std::size_t different = 0, all = 0;
    each_dda([&](const Sums&, std::size_t d, std::size_t n) { different += d, all += n; });
    return {double(different) / double(all), text("%zu of %zu pixels", different, all)};
}

Measured measure_dda_sum() {
    Measured worst;
    each_dda([&](const Sums& sums, std::size_t, std::size_t) {
        worst.see(sums.off.error, [&] { return sums.off.worst; });
    });
    return worst;
}

// The part of a ring with n . p <= limit.
Ring cut(const Ring& ring, glm::dvec2 n, double limit) {
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        const double out_a = n.x * a.x + n.y * a.y - limit, out_b = n.x * b.x + n.y * b.y - limit;
        if (out_a <= 0) kept.push_back(a);
        if ((out_a < 0 && out_b > 0) || (out_a > 0 && out_b < 0))
            kept.push_back(a + out_a / (out_a - out_b) * (b - a));
    }
    return kept;
}

double area_in_pixel(const Ring& ring, int x, int y) {
    const Ring inside =
        cut(cut(cut(cut(ring, {1, 0}, x + 0.5), {-1, 0}, 0.5 - x), {0, 1}, y + 0.5), {0, -1}, 0.5 - y);
    double twice = 0;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const glm::dvec2 a = inside[i], b = inside[(i + 1) % inside.size()];
        twice += (a.x - x) * (b.y - y) - (b.x - x) * (a.y - y);
    }
    return twice / 2;
}

struct Line {
    glm::dvec2 a, b;
    double width;
};

// The largest error of a pixel, and the root of the mean square over those that have light or should have.
struct Errors {
    Measured largest{}, rms{};
};

template <class Draw, class Truth>
Errors over_lines(double least_width, double most_width, Draw draw, Truth truth) {
    Random random(2);
    Errors errors;
    double squares = 0, pixels = 0;
    for (int i = 0; i < 600; ++i) {
        const Line line{{random.between(0, 1), random.between(0, 1)},
                        {random.between(-40, 40), random.between(-40, 40)},
                        random.between(least_width, most_width)};
        std::map<std::pair<int, int>, double> light;
        draw(line, [&](int y, int x0, int x1, int coverage) {
            for (int x = x0; x < x1; ++x) light[{x, y}] = double(coverage) / raster::full_coverage;
        });
        const double margin = line.width / 2 + 2;
        const auto low = [&](double p, double q) { return int(std::floor(std::min(p, q) - margin)); };
        const auto high = [&](double p, double q) { return int(std::ceil(std::max(p, q) + margin)); };
        for (int y = low(line.a.y, line.b.y); y <= high(line.a.y, line.b.y); ++y)
            for (int x = low(line.a.x, line.b.x); x <= high(line.a.x, line.b.x); ++x) {
                const auto found = light.find({x, y});
                const double ours = found == light.end() ? 0 : found->second, right = truth(line, x, y);
                if (ours == 0 && right < 1e-9) continue;
                squares += (ours - right) * (ours - right), ++pixels;
                errors.largest.see(std::abs(ours - right), [&] {
                    return text("pixel (%d, %d): %.4f for %.4f; (%.3f, %.3f) to (%.3f, %.3f), width %.3f", x,
                                y, ours, right, line.a.x, line.a.y, line.b.x, line.b.y, line.width);
                });
            }
    }
    errors.rms = {std::sqrt(squares / pixels), text("%.0f pixels", pixels)};
    return errors;
}

const Errors& wu() {
    static const Errors errors = over_lines(
        1, 1, [](const Line& line, auto cover) { raster::line_wu(line.a, line.b, picture, cover); },
        [](const Line& line, int x, int y) {
            const auto corners = raster::line_outline(line.a, line.b, line.width);
            return area_in_pixel(Ring(corners.begin(), corners.end()), x, y);
        });
    return errors;
}
Measured measure_wu() { return wu().largest; }
Measured measure_wu_rms() { return wu().rms; }

const Errors& gupta_sproull() {
    static const Errors errors = over_lines(
        0.5, 4,
        [](const Line& line, auto cover) {
            raster::line_gupta_sproull(line.a, line.b, line.width, picture, cover);
        },
        [](const Line& line, int x, int y) {
            return tests::cone_over_line(x, y, line.a.x, line.a.y, line.b.x, line.b.y, line.width);
        });
    return errors;
}
Measured measure_gupta_sproull() { return gupta_sproull().largest; }
Measured measure_gupta_sproull_rms() { return gupta_sproull().rms; }

Measured measure_cone_table() {
    Measured worst;
    for (int i = -(1 << 15); i <= 1 << 15; ++i) {
        const double s = i * 0x1p-15, exact = tests::cone_over_rectangle(-1, s, -1, 1);
        worst.see(std::abs(raster::cone_table()(std::int64_t{i} << 17) * 0x1p-30 - exact),
                  [&] { return text("distance %.6f", s); });
    }
    return worst;
}

constexpr Measurement measurements[] = {
    {"line, dda", measure_dda},
    {"line, dda, sum", measure_dda_sum},
    {"line, wu", measure_wu},
    {"line, wu, rms", measure_wu_rms},
    {"line, gupta-sproull", measure_gupta_sproull},
    {"line, gupta-sproull, rms", measure_gupta_sproull_rms},
    {"cone table", measure_cone_table},
};

}  // namespace

std::span<const Measurement> line_measurements() { return measurements; }

}  // namespace relevo::accuracy
