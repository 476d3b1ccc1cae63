// A piece of work for each row of the accuracy table that has code of its own. scripts/instructions runs it
// under valgrind, which counts the instructions of each and writes them down under the row's name.
//   instructions             the work
//   instructions --table     the figures of the table: a row, a tab, the number
#include <valgrind/callgrind.h>

#include <array>
#include <cstdio>
#include <cstring>

#include "pipeline/clip_polygon.hpp"
#include "pipeline/elementary.hpp"
#include "pipeline/normalize.hpp"
#include "pipeline/viewport.hpp"
#include "raster/cone_table.hpp"
#include "raster/curve_coverage.hpp"
#include "raster/depth.hpp"
#include "raster/interpolate.hpp"
#include "raster/line_dda.hpp"
#include "raster/line_gupta_sproull.hpp"
#include "raster/line_outline.hpp"
#include "raster/line_wu.hpp"
#include "raster/output.hpp"
#include "raster/shading.hpp"
#include "raster/supersample.hpp"
#include "raster/texture.hpp"
#include "raster/weighted_coverage.hpp"
#include "samples/scene/accuracy.hpp"
#include "tests/accuracy/measurement.hpp"

namespace {

using namespace relevo;
using pipeline::Degrees;
using pipeline::HPoint;
using pipeline::Scalar;
using pipeline::Vec3;

constexpr int calls = 1000;

// The compiler has to compute the value, and may compute nothing ahead.
template <class Value>
void keep(const Value& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

// `work(i)` for each i. The dump carries the row's name; the loop itself is subtracted by the script.
template <class Work>
[[gnu::noinline]] void count(const char* row, Work work) {
    CALLGRIND_ZERO_STATS;
    for (int i = 0; i < calls; ++i) keep(work(i));
    CALLGRIND_DUMP_STATS_AT(row);
}

struct Inputs {
    std::array<double, calls> angle, positive, exponent;
    std::array<Scalar, calls> unit;
    std::array<Vec3, calls> vector;
    std::array<pipeline::Vec2, calls> uv;
    std::array<raster::EdgeValues, calls> values;
};

Inputs make_inputs() {
    accuracy::Random random(1);
    const auto scalar = [&](double low, double high) {
        return static_cast<Scalar>(random.between(low, high));
    };
    Inputs in;
    for (std::size_t i = 0; i < calls; ++i) {
        in.angle[i] = random.between(-360, 360);
        in.positive[i] = random.of_any_size(0.001, 1000);
        in.exponent[i] = random.between(-100, 100);
        in.unit[i] = scalar(0.1, 1);
        in.vector[i] = {scalar(-1, 1), scalar(-1, 1), scalar(-1, 1)};
        in.values[i] = {random.whole(0, 1 << 20), random.whole(0, 1 << 20), random.whole(0, 1 << 20)};
        in.uv[i] = {scalar(-2, 2), scalar(-2, 2)};
    }
    return in;
}

void elementary(const Inputs& in) {
    count("sin", [&](int i) { return pipeline::sin(Degrees{in.angle[std::size_t(i)]}); });
    count("cos", [&](int i) { return pipeline::cos(Degrees{in.angle[std::size_t(i)]}); });
    count("tan", [&](int i) { return pipeline::tan(Degrees{in.angle[std::size_t(i)]}); });
    count("direction", [&](int i) {
        return pipeline::angle_of(in.angle[std::size_t(i)], in.exponent[std::size_t(i)]).value;
    });
    count("log2", [&](int i) { return pipeline::log2(in.positive[std::size_t(i)]); });
    count("exp2", [&](int i) { return pipeline::exp2(in.exponent[std::size_t(i)]); });
    const auto power = [&](const char* row, Scalar n) {
        const pipeline::Exponent exponent = pipeline::exponent(n);
        keep(exponent);
        count(row, [&](int i) { return pipeline::power(in.unit[std::size_t(i)], exponent); });
    };
    power("power, exponent 32", 32);
    power("power, whole exponent", 100);
    power("power, any exponent", Scalar(20.5));
    count("normalize", [&](int i) { return pipeline::normalize(in.vector[std::size_t(i)]); });
}

raster::Triangle make_triangle() {
    const pipeline::SnappedCorner a{300, 200, Scalar(0.5), Scalar(0.25)}, b{90000, 1500, Scalar(0.25), 1},
        c{4000, 80000, Scalar(0.75), Scalar(0.5)};
    return raster::make_triangle(a, b, c);
}

void geometry(const Inputs& in) {
    pipeline::RoundedProjective<pipeline::Clip, pipeline::Object> map{
        {{1, 2, 3, 4}, {4, 3, 2, 1}, {0, 1, 0, 2}, {0, 0, -1, 3}}};
    keep(map);
    count("vertex to clip space",
          [&](int i) { return map * pipeline::Point<pipeline::Object>{in.vector[std::size_t(i)]}; });
    const pipeline::Viewport viewport{1920, 1080};
    keep(viewport);
    count("snapping", [&](int i) {
        const Vec3& v = in.vector[std::size_t(i)];
        return pipeline::to_window({{v.x, v.y, v.z, in.unit[std::size_t(i)]}}, viewport);
    });
    count("clipped corner", [&](int i) {
        const Vec3& v = in.vector[std::size_t(i)];
        const double w = in.unit[std::size_t(i)];
        const pipeline::ClipCorner<0> inside{{v.x, v.y, w / 2, w}, {}, 0},
            outside{{v.y, v.z, w + w, w}, {}, 0};
        return pipeline::rounded_position(
            pipeline::crossing<0>(pipeline::guard_planes[0], 1, inside, outside, pipeline::guard_planes),
            pipeline::guard_planes);
    });
    const raster::Triangle triangle = make_triangle();
    const raster::Interpolator interpolator = raster::make_interpolator(triangle);
    keep(interpolator), keep(triangle);
    const auto values = [&](int i) -> const raster::EdgeValues& { return in.values[std::size_t(i)]; };
    count("depth", [&](int i) { return raster::depth(interpolator, values(i)); });
    count("perspective weight", [&](int i) { return raster::perspective_weights(interpolator, values(i)); });
    std::array<Scalar, 2> u0{0, 0}, u1{1, 0}, u2{0, 1};
    const auto plane = raster::make_plane(u0, u1, u2);
    keep(plane);
    count("perspective u, v", [&](int i) {
        return raster::interpolate(plane, raster::perspective_weights(interpolator, values(i)));
    });
}

raster::Texture make_texture() {
    raster::Texture texture{64, 64, {}, Scalar(1.0 / 65535)};
    for (int i = 0; i < 64 * 64; ++i) texture.texels.push_back({std::uint16_t(i * 16), 1, 2, 0});
    return texture;
}

void texture_and_output(const Inputs& in) {
    const raster::Texture texture = make_texture();
    count("texture, nearest", [&](int i) { return raster::sample_nearest(texture, in.uv[std::size_t(i)]); });
    count("texture, bilinear",
          [&](int i) { return raster::sample_bilinear(texture, in.uv[std::size_t(i)]); });
    count("output, srgb", [&](int i) { return raster::to_srgb8(in.unit[std::size_t(i)]); });
    count("output, raw", [&](int i) { return raster::to_raw8(in.unit[std::size_t(i)]); });
}

// A step along a line: the first call draws ten lines of a hundred steps, the others do nothing.
template <class DrawLine>
void count_steps(const char* row, DrawLine draw_line) {
    static std::array<std::int32_t, 128 * 128> picture;
    keep(picture);
    count(row, [&](int i) {
        for (int slope = 0; i == 0 && slope < 10; ++slope)
            draw_line(10 * slope, [](int y, int x, int coverage) {
                picture[static_cast<std::size_t>(128 * y + x)] = coverage;
            });
        return i;
    });
    keep(picture);
}

void lines(const Inputs& in) {
    const raster::PixelBox box{0, 0, 127, 127};
    count_steps("line, dda", [&](int y, auto light) {
        raster::line_dda({5, 5}, {105, 5 + y}, box, [&](int px, int py) { light(py, px, 1); });
    });
    count_steps("line, wu", [&](int y, auto light) {
        raster::line_wu({5, 5}, {105, 5 + y}, box, [&](int py, int px, int, int c) { light(py, px, c); });
    });
    count_steps("line, gupta-sproull", [&](int y, auto light) {
        raster::line_gupta_sproull({5, 5}, {105, 5 + y}, 1, box,
                                   [&](int py, int px, int, int c) { light(py, px, c); });
    });
    const auto outline = [](int y) {
        const auto corners = raster::line_outline({5, 5}, {105, 5 + y}, 1);
        return std::vector<std::vector<glm::dvec2>>{{corners.begin(), corners.end()}};
    };
    count_steps("area coverage", [&](int y, auto light) {
        const auto corners = raster::line_outline({5, 5}, {105, 5 + y}, 1);
        raster::area_coverage(std::span<const glm::dvec2>(corners), box,
                              [&](int py, int px, int, int c) { light(py, px, c); });
    });
    count_steps("weighted coverage", [&](int y, auto light) {
        raster::weighted_coverage(outline(y), raster::InsideRule::NonZero, box,
                                  [&](int py, int px, int, int c) { light(py, px, c); });
    });
    const auto samples = [&](const char* row, int n) {
        count_steps(row, [&](int y, auto light) {
            raster::supersample(n, outline(y), raster::InsideRule::NonZero, box,
                                [&](int py, int px, int, int c) { light(py, px, c); });
        });
    };
    samples("1 x 1 samples", 1), samples("2 x 2 samples", 2), samples("4 x 4 samples", 4);
    samples("8 x 8 samples", 8), samples("16 x 16 samples", 16);
    const raster::ConeTable& table = raster::cone_table();
    count("cone table", [&](int i) {
        return table(static_cast<std::int64_t>(in.unit[static_cast<std::size_t>(i)] * Scalar(0x1p32)));
    });
}

// Draws once for all calls: its edges touch about as many pixels as there are calls.
template <class Draw>
void count_edge_pixels(const char* row, Draw draw) {
    static std::array<int, 128 * 128> picture;
    count(row, [&](int i) {
        if (i == 0)
            draw([](int y, int x0, int, int coverage) {
                picture[static_cast<std::size_t>(128 * y + x0)] = coverage;
            });
        return i;
    });
    keep(picture);
}

void curves() {
    const raster::PixelBox box{0, 0, 127, 127};
    const glm::dvec2 center{64.3, 63.8};
    count_edge_pixels("disc, area", [&](auto cover) {
        for (const double r : {10.3, 20.1, 25.4, 30.2, 40.5}) raster::disc_coverage(center, r, r, box, cover);
    });
    count_edge_pixels("ring, area", [&](auto cover) {
        for (const double r : {10.3, 20.1, 40.5}) raster::ring_coverage(center, r, r, 1, box, cover);
    });
}

// A pixel of each shading, with one point light; of the row that names the setting.
void shading(const Inputs& in) {
    const pipeline::EyeLight light{false, {1, 2, 3}, {1, 1, 1}};
    const raster::Surface surface{
        {{&light, 1}, Scalar(0.1), Scalar(0.7), Scalar(0.4), pipeline::exponent(32), false},
        {1, 1, 1},
        nullptr,
        raster::Filter::Nearest,
        false};
    keep(surface);
    const auto toward = [&](int i) { return Vec3{0, 0, 2} + in.vector[std::size_t(i)]; };
    count("light", [&](int i) {
        return pipeline::reflect(surface.lighting, in.vector[std::size_t(i)] - Vec3{0, 0, 5}, toward(i));
    });
    const pipeline::Reflection face{{1, 1, 1}, {0, 0, 0}};
    keep(face);
    const raster::VaryingPlane<3> plane{{0, 0, 0}, {1, 2, 3}, {3, 2, 1}};
    keep(plane);
    const auto gouraud = [&](int i) {
        const Vec3& b = in.vector[std::size_t(i)];
        const auto varying = raster::interpolate(plane, {b.x, b.y, b.z});
        return raster::Gouraud<false>::pixel(surface, {}, varying.data());
    };
    for (const auto& row : scene::accuracy_table()) {
        if (row.name.starts_with("gouraud,")) count(row.name.data(), gouraud);
        if (row.name.starts_with("flat,"))
            count(row.name.data(), [&](int) { return raster::Flat<false>::pixel(surface, face, nullptr); });
    }
}

}  // namespace

int main(int arguments, char** words) {
    if (arguments > 1 && std::strcmp(words[1], "--table") == 0) {
        for (const auto& row : scene::accuracy_table())
            if (row.instructions != 0) std::printf("%s\t%d\n", row.name.data(), row.instructions);
        return 0;
    }
    const Inputs in = make_inputs();
    count("", [&](int i) { return in.unit[std::size_t(i)]; });  // the loop itself
    elementary(in);
    geometry(in);
    texture_and_output(in);
    shading(in);
    lines(in);
    curves();
}
