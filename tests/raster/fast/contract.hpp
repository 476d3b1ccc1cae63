// Every function of the shared arithmetic, called on columns of 32-bit patterns: once for a plain number,
// once for N lanes. contract_test.cpp compares the two.
#pragma once
#include <cstdint>

#include "pipeline/clip_codes.hpp"
#include "pipeline/viewport.hpp"
#include "raster/interpolate.hpp"
#include "raster/output.hpp"
#include "raster/shading.hpp"

namespace relevo::tests {

using pipeline::Scalar;

enum class Function {
    Words,
    Rows,
    Vectors,
    Normalize,
    Power,
    Reflect,
    ReflectFace,
    ClipCodes,
    Window,
    Triangle,
    Depth,
    Interpolate,
    TexelPosition,
    Sample,
    Output,
    Corner,
    Pixel,
};
inline constexpr int max_in = 14, max_out = 32;

// What the functions read beside their numbers.
struct Setting {
    Function function = Function::Words;
    Scalar row[4] = {};
    pipeline::Exponent exponent{};
    raster::Surface surface{};
    bool mirrored = false;
    pipeline::Viewport viewport{};
    int program = 0;  // 0..7: Unlit, Flat, Gouraud, Phong; the odd ones textured
    int size = 1;     // of a texture's side
    raster::Output output{};
};

// `count` rows, a multiple of 16.
using RunContract = void(const Setting&, const std::uint32_t* const* in, std::uint32_t* const* out,
                         int count);
RunContract contract_sse4, contract_avx2, contract_avx512;

// `io` reads and writes one group of lanes: real(k), whole(k) and below(k, n) are column k of the input,
// put() appends to the output. Returns the number of columns written.
template <class Program, class Real, class Io>
void apply_program(const Setting& s, Io& io) {
    using pipeline::Vec3Of;
    if (s.function == Function::Corner) {
        const raster::ShadedVertexOf<Real> vertex{Vec3Of<Real>{io.real(0), io.real(1), io.real(2)},
                                                  Vec3Of<Real>{io.real(3), io.real(4), io.real(5)},
                                                  {io.real(6), io.real(7)}};
        for (const Real& number : Program::corner(s.surface, vertex)) io.put(number);
        return;
    }
    Real varying[8];
    for (int k = 0; k < 8; ++k) varying[k] = io.real(k);
    pipeline::RgbOf<Real> color;
    if constexpr (Program::needs_face)
        color = Program::template pixel<Real>(
            s.surface,
            pipeline::ReflectionOf<Real>{{io.real(8), io.real(9), io.real(10)},
                                         {io.real(11), io.real(12), io.real(13)}},
            varying);
    else
        color = Program::template pixel<Real>(s.surface, {}, varying);
    io.put(color);
}

template <class Real, class Io>
void apply(const Setting& s, Io& io) {
    using namespace pipeline;
    using namespace raster;
    const auto vector = [&](int k) { return Vec3Of<Real>{io.real(k), io.real(k + 1), io.real(k + 2)}; };
    const auto corner = [&](int k) {
        return SnappedCornerOf<Real>{io.whole(k), io.whole(k + 1), io.real(k + 2), io.real(k + 3)};
    };
    const auto edges = [&](int k) {
        const auto product = [&](int i) {
            return to_big(io.whole(i)) * to_big(io.whole(i + 1)) + to_big(Whole<Real>(0));
        };
        return EdgeValuesOf<Real>{product(k), product(k + 2), product(k + 4)};
    };
    switch (s.function) {
        case Function::Words: {
            const Real x = io.real(0), y = io.real(1);
            const Whole<Real> n = io.whole(2);
            io.put(select(x > y, x, y));
            io.put(select(x >= y, x, y));
            io.put(select(x < y, x, y));
            io.put(select(x <= y, x, y));
            io.put(select(x == y, x, y));
            io.put(select(is_finite(x), y, x));
            io.put(to_real(n));
            io.put(to_real(to_word(n)));
            io.put(to_real(to_whole(to_word(n) >> 3)));
            io.put(n >> 8);
            io.put(sqrt(x));
            io.put(floor(x));
            io.put(-x);
            io.put(to_wide(x) * to_wide(y) + to_wide(n));
            io.put(rounded(to_wide(x) + to_wide(y)));
            break;
        }
        case Function::Rows:
            io.put(row_times_point(s.row, vector(0)));
            io.put(row_times_direction(s.row, vector(0)));
            break;
        case Function::Vectors:
            io.put(pipeline::dot<Real>(vector(0), vector(3)));
            io.put(pipeline::cross<Real>(vector(0), vector(3)));
            break;
        case Function::Normalize:
            io.put(pipeline::normalize<Real>(vector(0)));
            break;
        case Function::Power:
            io.put(power(io.real(0), s.exponent));
            break;
        case Function::Reflect: {
            const ReflectionOf<Real> r = pipeline::reflect<Real>(s.surface.lighting, vector(0), vector(3));
            io.put(r.amount);
            io.put(r.gloss);
            break;
        }
        case Function::ReflectFace: {
            const ReflectionOf<Real> r = reflect_face<Real>(s.surface, {vector(0), vector(3), vector(6)},
                                                            io.real(9) > Real(0), s.mirrored);
            io.put(r.amount);
            io.put(r.gloss);
            break;
        }
        case Function::ClipCodes:
            io.put(lanes_clip_codes<Real>({io.real(0), io.real(1), io.real(2), io.real(3)}));
            break;
        case Function::Window: {
            const auto c =
                lanes_to_window<Real>({io.real(0), io.real(1), io.real(2), io.real(3)}, s.viewport);
            io.put(c.x);
            io.put(c.y);
            io.put(c.z);
            io.put(c.rw);
            break;
        }
        case Function::Triangle: {
            const auto t = make_triangle(corner(0), corner(4), corner(8));
            io.put(is_top_left(t.corner[1].x - t.corner[0].x, t.corner[1].y - t.corner[0].y));
            for (const auto& number : {t.area, t.dx1, t.dy1, t.dx2, t.dy2, t.bias[0], t.bias[1], t.bias[2]})
                io.put(to_wide(number) + 0.0);  // whole numbers have one zero
            const InterpolatorOf<Real> i = make_interpolator(t);
            for (const auto& number : {i.z0, i.g1, i.g2, i.rw0, i.rw1, i.rw2}) io.put(number);
            break;
        }
        case Function::Depth: {
            const auto real = [&](int k) { return to_wide(io.real(k)); };
            const InterpolatorOf<Real> i{real(6), real(7), real(8), real(9), real(10), real(11)};
            io.put(depth<Real>(i, edges(0)));
            const auto w = perspective_weights<Real>(i, edges(0));
            io.put(w.b1);
            io.put(w.b2);
            io.put(w.s);
            const Interpolator one{0.75, -0.001, 0.01, 0.5, 0.25, 2};  // of one triangle in all lanes
            io.put(depth<Real>(one, edges(0)));
            const auto same = perspective_weights<Real>(one, edges(0));
            io.put(same.b1);
            io.put(same.b2);
            break;
        }
        case Function::Interpolate: {
            const auto numbers = [&](int k) { return std::array<Real, 2>{io.real(k), io.real(k + 1)}; };
            const PerspectiveWeightsOf<Real> w{io.real(6), io.real(7), {}};
            for (const Real& number : interpolate(make_plane(numbers(0), numbers(2), numbers(4)), w))
                io.put(number);
            const VaryingPlane<1> one = make_plane<1>({s.row[0]}, {s.row[1]}, {s.row[2]});
            io.put(interpolate(one, w)[0]);
            break;
        }
        case Function::TexelPosition: {
            io.put(repeat(io.real(0)));
            const auto p = texel_position(io.real(0), s.size);
            io.put(p.low);
            io.put(p.high);
            io.put(p.weight);
            break;
        }
        case Function::Sample:
            io.put(sample<Real>(*s.surface.texture, s.surface.filter, {io.real(0), io.real(1)}));
            break;
        case Function::Output:
            io.put(packed_rgba8(RgbOf<Real>{io.real(0), io.real(1), io.real(2)}, s.output));
            break;
        case Function::Corner:
        case Function::Pixel:
            switch (s.program) {
                case 0:
                    apply_program<Unlit<false>, Real>(s, io);
                    break;
                case 1:
                    apply_program<Unlit<true>, Real>(s, io);
                    break;
                case 2:
                    apply_program<Flat<false>, Real>(s, io);
                    break;
                case 3:
                    apply_program<Flat<true>, Real>(s, io);
                    break;
                case 4:
                    apply_program<Gouraud<false>, Real>(s, io);
                    break;
                case 5:
                    apply_program<Gouraud<true>, Real>(s, io);
                    break;
                case 6:
                    apply_program<Phong<false>, Real>(s, io);
                    break;
                case 7:
                    apply_program<Phong<true>, Real>(s, io);
                    break;
            }
            break;
    }
}

}  // namespace relevo::tests
