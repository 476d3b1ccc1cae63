// Forms of antialiasing: covered area against rational numbers, the cone against sums of slices, sample
// points against the area.
#include "raster/weighted_coverage.hpp"
#include "tests/accuracy/coverage_families.hpp"
#include "tests/raster/cone_integral.hpp"
#include "tests/raster/coverage_grid.hpp"
#include "tests/support/exact_area.hpp"

namespace relevo::accuracy {
namespace {

namespace exact = tests::exact;

constexpr raster::PixelBox box{-1, -1, 10, 10};

// The largest error, in 1/65536, and the root of the mean square over pixels that the border crosses.
struct AreaErrors {
    Measured largest{}, rms{};
};
const AreaErrors& area_errors() {
    static const AreaErrors errors = [] {
        AreaErrors found;
        double squares = 0, pixels = 0;
        tests::RandomPlaces random(41);
        for (std::size_t i = 0; i < 160; ++i) {
            const std::size_t family = i % std::size(tests::triangle_families);
            const Ring triangle = tests::hard_triangle(family, random);
            const exact::RationalRing ring = exact::rational(triangle);
            tests::CoverageGrid grid(box);
            raster::area_coverage(std::span<const glm::dvec2>(triangle), box, grid);
            grid.each([&](int x, int y, int coverage) {
                const exact::Rational area = abs(exact::area_in_pixel(ring, x, y)) * raster::full_coverage;
                if (area == 0 || area == raster::full_coverage) return;
                const double off = static_cast<double>(area - coverage);
                squares += off * off, ++pixels;
                found.largest.see(std::abs(off), [&] {
                    return text("%s, pixel (%d, %d) of triangle %d", tests::triangle_families[family], x, y,
                                int(i));
                });
            });
        }
        found.rms = {std::sqrt(squares / pixels), text("%.0f pixels", pixels)};
        return found;
    }();
    return errors;
}
Measured measure_area() { return area_errors().largest; }
Measured measure_area_rms() { return area_errors().rms; }

// The plane cut into four by a corner in the cone: the volume over one of them by Gauss' rule, and all four
// fill the cone.
Measured measure_weighted() {
    Measured worst;
    Random random(42);
    for (int i = 0; i < 60; ++i) {
        const double x = random.whole(-65536, 65536) * 0x1p-16, y = random.whole(-65536, 65536) * 0x1p-16;
        double quarters[4];
        const double far = 20;
        const glm::dvec2 at{x, y}, corner[4] = {{far, -far}, {far, far}, {-far, far}, {-far, -far}},
                                   side[4] = {{x, -far}, {far, y}, {x, far}, {-far, y}};
        for (int k = 0; k < 4; ++k) {
            const std::vector<Ring> rings{{at, side[k], corner[k], side[(k + 1) % 4]}};
            int got = 0;
            raster::weighted_coverage(rings, raster::InsideRule::NonZero, {0, 0, 0, 0},
                                      [&](int, int, int, int c) { got = c; });
            quarters[k] = got / 65536.0;
        }
        const double sum = tests::cone_over_rectangle(x, 1, -1, y);  // the quarter to the right and above
        worst.see(std::abs(sum - quarters[0]) * 65536,
                  [&] { return text("a corner at (%.5f, %.5f)", x, y); });
        worst.see(std::abs(quarters[0] + quarters[1] + quarters[2] + quarters[3] - 1) * 65536 / 4,
                  [&] { return text("four corners at (%.5f, %.5f)", x, y); });
    }
    return worst;
}

template <int n>
Measured measure_samples() {
    return against_area(CoverageFamily::LongEdge, 2000, samples(n)).largest;
}
template <int n>
Measured measure_samples_rms() {
    const CoverageErrors errors = against_area(CoverageFamily::LongEdge, 2000, samples(n));
    return {errors.rms, "all edges"};
}

constexpr Measurement measurements[] = {
    {"area coverage", measure_area},
    {"area coverage, rms", measure_area_rms},
    {"weighted coverage", measure_weighted},
    {"1 x 1 samples", measure_samples<1>},
    {"1 x 1 samples, rms", measure_samples_rms<1>},
    {"2 x 2 samples", measure_samples<2>},
    {"2 x 2 samples, rms", measure_samples_rms<2>},
    {"4 x 4 samples", measure_samples<4>},
    {"4 x 4 samples, rms", measure_samples_rms<4>},
    {"8 x 8 samples", measure_samples<8>},
    {"8 x 8 samples, rms", measure_samples_rms<8>},
    {"16 x 16 samples", measure_samples<16>},
    {"16 x 16 samples, rms", measure_samples_rms<16>},
};

}  // namespace

std::span<const Measurement> plane_measurements() { return measurements; }

}  // namespace relevo::accuracy
