// From a vertex to the numbers of a pixel, against sums with 64 significant bits.
#include <array>

#include "pipeline/clip_polygon.hpp"
#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"
#include "pipeline/viewport.hpp"
#include "raster/interpolate.hpp"
#include "raster/triangle_edge.hpp"
#include "tests/accuracy/measurement.hpp"

namespace relevo::accuracy {
namespace {

using pipeline::Clip;
using pipeline::Eye;
using pipeline::HPoint;
using pipeline::Point;
using pipeline::Scalar;
using pipeline::SnappedCorner;
using Long = long double;
static_assert(std::numeric_limits<Long>::digits >= 64);

pipeline::Projective<Clip, Eye> random_projective(Random& random) {
    // One after the other: the order of a call's arguments is the compiler's to choose.
    const double fov = random.between(10, 120), aspect = random.between(0.5, 2),
                 near = random.of_any_size(0.01, 1);
    const glm::dvec3 axis{random.between(-1, 1), random.between(-1, 1), 1};
    const double angle = random.between(0, 360), away = random.between(1, 50);
    const auto clip_from_eye =
        pipeline::perspective({fov}, aspect, near, 1000, pipeline::DepthRange::Reversed);
    return {(*clip_from_eye).m *
            (pipeline::translation_matrix({0, 0, -away}) * *pipeline::rotation_matrix(axis, {angle}))};
}

Measured measure_vertex() {
    Random random(11);
    Measured worst;
    for (int i = 0; i < 20000; ++i) {
        const auto map = random_projective(random);
        const pipeline::Vec3 p{static_cast<Scalar>(random.between(-9, 9)),
                               static_cast<Scalar>(random.between(-9, 9)),
                               static_cast<Scalar>(random.between(-9, 9))};
        const HPoint<Clip> ours = pipeline::rounded(map) * Point<Eye>{p};
        for (int r = 0; r < 4; ++r) {
            const Long terms[4] = {Long(map.m[0][r]) * p.x, Long(map.m[1][r]) * p.y, Long(map.m[2][r]) * p.z,
                                   Long(map.m[3][r])};
            Long exact = 0, sizes = 0;
            for (const Long t : terms) exact += t, sizes += std::abs(t);
            if (sizes == 0) continue;
            worst.see(double(std::abs(ours.v[r] - exact) / sizes) / float_unit,
                      [&] { return text("row %d times (%.9g, %.9g, %.9g)", r, p.x, p.y, p.z); });
        }
    }
    return worst;
}

HPoint<Clip> random_visible(Random& random) {
    const double w = random.of_any_size(0.01, 1000);
    return {{static_cast<Scalar>(random.between(-7, 7) * w), static_cast<Scalar>(random.between(-7, 7) * w),
             static_cast<Scalar>(random.between(0, w)), static_cast<Scalar>(w)}};
}

Measured measure_snapping() {
    Random random(12);
    Measured worst;
    for (int i = 0; i < 100000; ++i) {
        const pipeline::Viewport viewport{random.whole(1, 8192), random.whole(1, 8192)};
        const HPoint<Clip> p = random_visible(random);
        const SnappedCorner ours = pipeline::to_window(p, viewport);
        const Long x = (Long(p.v.x) / p.v.w + 1) / 2 * viewport.width,
                   y = (1 - Long(p.v.y) / p.v.w) / 2 * viewport.height;
        const Long error = std::max(std::abs(Long(ours.x) / 256 - x), std::abs(Long(ours.y) / 256 - y));
        worst.see(double(error), [&] {
            return text("(%.9g, %.9g, w %.9g) at %dx%d", p.v.x, p.v.y, p.v.w, viewport.width,
                        viewport.height);
        });
    }
    return worst;
}

// Against the weighted sum of the two ends, as a share of their largest coordinate.
Measured measure_clipped_corner() {
    Random random(13);
    Measured worst;
    const auto& planes = pipeline::view_volume_planes;
    for (int i = 0; i < 100000; ++i) {
        const std::size_t which = std::size_t(i) % planes.size();
        const double size = random.of_any_size(1e-3, 1e3);
        pipeline::ClipCorner<0> a{}, b{};
        for (int k = 0; k < 4; ++k) {
            a.position[k] = static_cast<Scalar>(random.between(-size, size));
            b.position[k] = static_cast<Scalar>(random.between(-size, size));
        }
        const auto inside = [&](const glm::dvec4& p) {
            return planes[which].factor * Long(p.w) - planes[which].sign * Long(p[planes[which].axis]);
        };
        if (inside(a.position) < 0) std::swap(a, b);
        const Long d_in = inside(a.position), d_out = inside(b.position);
        if (!(d_in >= 0) || !(d_out < 0)) continue;
        const auto made = pipeline::crossing(planes[which], 1u << which, a, b, planes);
        const HPoint<Clip> ours = pipeline::rounded_position(made, planes);
        Long largest = 0;
        for (int k = 0; k < 4; ++k)
            largest = std::max({largest, std::abs(Long(a.position[k])), std::abs(Long(b.position[k]))});
        for (int k = 0; k < 4; ++k) {
            const Long exact = (d_in * b.position[k] - d_out * a.position[k]) / (d_in - d_out);
            worst.see(double(std::abs(ours.v[k] - exact) / largest) / float_unit, [&] {
                return text("coordinate %d between w %.9g and w %.9g", k, a.position.w, b.position.w);
            });
        }
    }
    return worst;
}

// A triangle of any size and shape in a window of 8192 pixels, and the centre of a pixel that it covers.
struct Sample {
    raster::Triangle triangle;
    raster::EdgeValues values;
};
bool next_sample(Random& random, Sample& sample) {
    const double size = random.of_any_size(300, 2097152);
    SnappedCorner c[3];
    double centre[2] = {0, 0};
    for (auto& corner : c) {
        corner.x = int(random.between(0, size)), corner.y = int(random.between(0, size));
        corner.z = static_cast<Scalar>(random.between(0, 1));
        corner.rw = static_cast<Scalar>(1 / random.of_any_size(1, 1000));
    }
    if (random.whole(0, 3) == 0) {  // a sliver: the third corner close to the edge of the two others
        const double t = random.between(0, 1);
        c[2].x = int(c[0].x + t * (c[1].x - c[0].x) + random.between(-300, 300));
        c[2].y = int(c[0].y + t * (c[1].y - c[0].y) + random.between(-300, 300));
    }
    double share[3] = {random.between(0, 1), random.between(0, 1), random.between(0, 1)};
    const double all = share[0] + share[1] + share[2];
    for (int k = 0; k < 3; ++k)
        centre[0] += share[k] / all * c[k].x / 256, centre[1] += share[k] / all * c[k].y / 256;
    const std::int64_t area = raster::area2(c[0], c[1], c[2]);
    if (area == 0) return false;
    const auto order = raster::canonical_order(c[0], c[1], c[2], area > 0);
    sample.triangle = raster::make_triangle(c[order.index[0]], c[order.index[1]], c[order.index[2]]);
    sample.values = raster::edge_values(sample.triangle, int(centre[0]), int(centre[1]));
    return raster::is_covered(sample.triangle, sample.values);
}

std::string describe(const Sample& s) {
    const auto& c = s.triangle.corner;
    return text("corners (%d, %d) (%d, %d) (%d, %d) /256, E = %lld %lld", c[0].x, c[0].y, c[1].x, c[1].y,
                c[2].x, c[2].y, static_cast<long long>(s.values.e1), static_cast<long long>(s.values.e2));
}

template <class Error>
Measured over_samples(Error error) {
    Random random(14);
    Measured worst;
    for (int i = 0; i < 200000; ++i)
        if (Sample s; next_sample(random, s)) worst.see(error(s, random), [&] { return describe(s); });
    return worst;
}

Measured measure_weights() {
    return over_samples([](const Sample& s, Random&) {
        const auto ours = raster::perspective_weights(raster::make_interpolator(s.triangle), s.values);
        const auto& c = s.triangle.corner;
        const Long q0 = Long(s.values.e0) * c[0].rw, q1 = Long(s.values.e1) * c[1].rw,
                   q2 = Long(s.values.e2) * c[2].rw, sum = q0 + q1 + q2;
        return double(std::max(std::abs(ours.b1 - q1 / sum), std::abs(ours.b2 - q2 / sum))) / float_unit;
    });
}

Measured measure_depth() {
    return over_samples([](const Sample& s, Random&) {
        const auto& c = s.triangle.corner;
        const Long exact = Long(c[0].z) + (Long(s.values.e1) * (Long(c[1].z) - c[0].z) +
                                           Long(s.values.e2) * (Long(c[2].z) - c[0].z)) /
                                              s.triangle.area;
        const Long largest = std::max({c[0].z, c[1].z, c[2].z});
        const Scalar ours = raster::depth(raster::make_interpolator(s.triangle), s.values);
        return double(std::abs(ours - exact) / largest) / 0x1p-23;
    });
}

Measured measure_perspective() {
    return over_samples([](const Sample& s, Random& random) {
        const auto b = raster::perspective_weights(raster::make_interpolator(s.triangle), s.values);
        std::array<Scalar, 1> u[3];
        Long largest = 0;
        for (auto& corner : u) corner[0] = static_cast<Scalar>(random.between(-1, 1));
        for (const auto& corner : u) largest = std::max(largest, std::abs(Long(corner[0])));
        const Scalar ours = raster::interpolate(raster::make_plane(u[0], u[1], u[2]), b)[0];
        const auto& c = s.triangle.corner;
        const Long q[3] = {Long(s.values.e0) * c[0].rw, Long(s.values.e1) * c[1].rw,
                           Long(s.values.e2) * c[2].rw};
        const Long exact = (q[0] * u[0][0] + q[1] * u[1][0] + q[2] * u[2][0]) / (q[0] + q[1] + q[2]);
        return double(std::abs(ours - exact) / largest) / float_unit;
    });
}

constexpr Measurement measurements[] = {
    {"vertex to clip space", measure_vertex},
    {"snapping", measure_snapping},
    {"clipped corner", measure_clipped_corner},
    {"perspective weight", measure_weights},
    {"depth", measure_depth},
    {"perspective u, v", measure_perspective},
};

}  // namespace

std::span<const Measurement> geometry_measurements() { return measurements; }

}  // namespace relevo::accuracy
