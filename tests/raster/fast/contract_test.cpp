// The shared arithmetic: N lanes give the same bits as a plain number, in every function, on numbers that are
// hard to get right. Not-a-number equals not-a-number, whatever its bits.
#include "tests/raster/fast/contract.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "raster/fast/draw_fast.hpp"
#include "tests/support/hard.hpp"

namespace relevo::tests {
namespace {

using hard::Random;
using pipeline::EyeLight;
using pipeline::LinearRgb;
using raster::Filter;
using raster::Texture;
using raster::fast::InstructionSet;

constexpr int rows = 4096;  // of one batch
constexpr int usual_cases = 1 << 20;

std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }
float number(std::uint32_t pattern) { return std::bit_cast<float>(pattern); }

// ------------------------------------------------------------------------------------------------ columns
struct Columns {
    explicit Columns(int count) : numbers(std::size_t(count * rows)) {
        for (int k = 0; k < count; ++k) at.push_back(numbers.data() + k * rows);
    }
    std::vector<std::uint32_t> numbers;
    std::vector<std::uint32_t*> at;  // each column
};

enum class Kind { Exact, Float, Low, High };  // of a column; Low and High: the words of a double

struct PlainIo {
    const std::uint32_t* const* in;
    std::uint32_t* const* out;
    Kind* kinds;
    int i, column = 0;

    float real(int k) const { return number(in[k][i]); }
    std::int32_t whole(int k) const { return static_cast<std::int32_t>(in[k][i]); }
    void put_bits(std::uint32_t pattern, Kind kind) { kinds[column] = kind, out[column++][i] = pattern; }
    void put(std::uint32_t a) { put_bits(a, Kind::Exact); }
    void put(std::int32_t a) { put(static_cast<std::uint32_t>(a)); }
    void put(bool a) { put(std::uint32_t{a}); }
    void put(float a) { put_bits(bits(a), Kind::Float); }
    void put(double a) {
        const auto pattern = std::bit_cast<std::uint64_t>(a);
        put_bits(static_cast<std::uint32_t>(pattern), Kind::Low);
        put_bits(static_cast<std::uint32_t>(pattern >> 32), Kind::High);
    }
    void put(const pipeline::Vec3& v) { put(v.x), put(v.y), put(v.z); }
    void put(const LinearRgb& c) { put(c.r), put(c.g), put(c.b); }
};

// ------------------------------------------------------------------------------------------------ numbers
const std::vector<float>& hard_numbers() {
    static const std::vector<float> all = [] {
        using Limits = std::numeric_limits<float>;
        std::vector<float> v;
        for (const float x : {0.0f,
                              Limits::denorm_min(),
                              0x1p-130f,
                              Limits::min(),
                              1e-30f,
                              1e-15f,
                              0x1p-12f,
                              0.25f,
                              0.5f,
                              0x1.fffffep-1f,
                              1.0f,
                              0x1.000002p0f,
                              1.5f,
                              2.0f,
                              2.5f,
                              7.0f,
                              255.5f,
                              0x1p23f,
                              0x1p24f,
                              2147483520.0f,
                              2147483648.0f,
                              4294967040.0f,
                              1e15f,
                              1e30f,
                              Limits::max(),
                              Limits::infinity(),
                              Limits::quiet_NaN()})
            v.push_back(x), v.push_back(-x);
        return v;
    }();
    return all;
}

float any_number(Random& random) {
    const auto& hard = hard_numbers();
    switch (random.integer(0, 3)) {
        case 0:
            return hard[std::size_t(random.integer(0, std::int64_t(hard.size()) - 1))];
        case 1:
            return number(static_cast<std::uint32_t>(random.bits() >> 32));
        default:
            return static_cast<float>(random.between(-2, 2));
    }
}

std::uint32_t whole(Random& random, std::int64_t limit) {
    const std::int64_t of[] = {limit, 300, 2};
    const std::int64_t within = of[random.integer(0, 2)];
    return static_cast<std::uint32_t>(random.integer(-within, within));
}

// ------------------------------------------------------------------------------------------------ the test
class Contract : public testing::TestWithParam<InstructionSet> {
  protected:
    using Fill = std::function<void(Random&, std::uint32_t* const* in, int row)>;

    static void fill_any(Random& random, std::uint32_t* const* in, int row) {
        for (int k = 0; k < max_in; ++k) in[k][row] = bits(any_number(random));
    }

    void same(const Setting& setting, int cases, const Fill& fill = fill_any) {
        RunContract* const run = GetParam() == InstructionSet::Sse4   ? contract_sse4
                                 : GetParam() == InstructionSet::Avx2 ? contract_avx2
                                                                      : contract_avx512;
        Random random(1);
        Columns in(max_in), plain(max_out), lanes(max_out);
        std::array<Kind, max_out> kinds{};
        const auto& hard = hard_numbers();
        std::size_t pair = 0;  // every two hard numbers meet in the first two columns
        for (int done = 0; done < cases; done += rows) {
            int columns = 0;
            for (int i = 0; i < rows; ++i) {
                fill(random, in.at.data(), i);
                if (fill.target<decltype(&fill_any)>() && pair < hard.size() * hard.size()) {
                    in.at[0][i] = bits(hard[pair % hard.size()]),
                    in.at[1][i] = bits(hard[pair / hard.size()]);
                    ++pair;
                }
                PlainIo io{in.at.data(), plain.at.data(), kinds.data(), i};
                apply<Scalar>(setting, io);
                columns = io.column;
            }
            run(setting, in.at.data(), lanes.at.data(), rows);
            for (int c = 0; c < columns; ++c)
                for (int i = 0; i < rows; ++i)
                    if (!equal(kinds[std::size_t(c)], plain.at.data() + c, lanes.at.data() + c, i)) {
                        std::string inputs;
                        char text[32];
                        for (const auto* column : in.at)
                            std::snprintf(text, sizeof text, " %a", number(column[i])), inputs += text;
                        FAIL() << "output " << c << " in lane " << i % 16 << ": plain " << std::hex
                               << plain.at[std::size_t(c)][i] << ", lanes " << lanes.at[std::size_t(c)][i]
                               << ", of" << inputs;
                    }
        }
    }

  private:
    static bool equal(Kind kind, std::uint32_t* const* a, std::uint32_t* const* b, int i) {
        if (a[0][i] == b[0][i]) return true;
        if (kind == Kind::Float) return std::isnan(number(a[0][i])) && std::isnan(number(b[0][i]));
        const auto wide = [&](std::uint32_t* const* of) {
            const auto* const* low = kind == Kind::High ? of - 1 : of;
            return std::bit_cast<double>(std::uint64_t{low[1][i]} << 32 | low[0][i]);
        };
        return kind >= Kind::Low && std::isnan(wide(a)) && std::isnan(wide(b));
    }
};

std::vector<InstructionSet> sets_of_this_machine() {
    const auto sets = raster::fast::instruction_sets();
    for (const InstructionSet set : {InstructionSet::Sse4, InstructionSet::Avx2, InstructionSet::Avx512})
        if (std::find(sets.begin(), sets.end(), set) == sets.end())
            std::printf("NOT RUN: this machine has no %s\n", std::string(name(set)).c_str());
    return {sets.begin(), sets.end()};
}
INSTANTIATE_TEST_SUITE_P(Lanes, Contract, testing::ValuesIn(sets_of_this_machine()), [](const auto& set) {
    std::string letters;
    for (const char c : name(set.param))
        if (c != '-') letters += c;
    return letters;
});

// ------------------------------------------------------------------------------------------------ surfaces
Texture random_texture(int width, int height, bool brightest) {
    Random random(static_cast<std::uint64_t>(width));
    Texture texture{width, height, {}, Scalar(1.0 / 65535)};
    for (int k = 0; k < width * height; ++k) {
        std::array<std::uint16_t, 4> texel;
        for (auto& channel : texel)
            channel = brightest ? 65535 : static_cast<std::uint16_t>(random.bits() >> 48);
        texture.texels.push_back(texel);
    }
    return texture;
}

struct Lit {  // a surface and what it points to
    std::vector<EyeLight> lights;
    Texture texture = random_texture(640, 427, false);
    raster::Surface surface{};

    explicit Lit(Scalar shininess, bool parallel = false, int count = 3, bool grey = false) {
        EyeLight all[] = {{false, {1, 2, 3}, {1, Scalar(0.5), Scalar(0.25)}},
                          {true, {0, Scalar(0.6), Scalar(0.8)}, {Scalar(0.1), 2, 1}},
                          {false, {-1, 0, -2}, {1, 0, -1}}};
        if (grey)
            for (EyeLight& light : all) light.color.r = light.color.b = light.color.g;
        lights.assign(all, all + count);
        surface.lighting = {lights,   Scalar(-0.0), Scalar(0.7), Scalar(0.4), pipeline::exponent(shininess),
                            parallel, grey};
        surface.color = {Scalar(0.8), Scalar(0.6), Scalar(0.4)};
        surface.texture = &texture;
        surface.filter = Filter::Bilinear;
    }
};

// ------------------------------------------------------------------------------------------------ functions
TEST_P(Contract, Words) { same({.function = Function::Words}, usual_cases); }

TEST_P(Contract, RowsOfMatrices) {
    same({.function = Function::Rows, .row = {0.3f, -1.7f, 1e-20f, 5.1f}}, usual_cases);
    same({.function = Function::Rows, .row = {1e20f, -1e20f, -0.0f, -0.0f}}, usual_cases / 4);
}

TEST_P(Contract, DotAndCross) { same({.function = Function::Vectors}, usual_cases); }

TEST_P(Contract, NormalizeAlsoExtremeLengths) {
    same({.function = Function::Normalize}, usual_cases);
    same({.function = Function::Normalize}, usual_cases / 4, [](Random& random, auto in, int row) {
        // squared lengths round the ends of the usual range, and no extreme lane beside them
        const double length = random.coin() ? 1e-15 : 1e15;
        const Scalar x = static_cast<Scalar>(length * random.between(0.9999999, 1.0000001));
        in[0][row] = bits(x), in[1][row] = bits(0.0f), in[2][row] = bits(-0.0f);
    });
}

TEST_P(Contract, PowerOfEveryKindOfExponent) {
    for (const Scalar n : {0.0f, 0.5f, 1.0f, 2.0f, 7.0f, 32.0f, 100.0f, 127.0f, 128.0f, 129.0f, 1000.0f})
        same({.function = Function::Power, .exponent = pipeline::exponent(n)},
             n == 32 ? usual_cases : usual_cases / 8);
}

TEST_P(Contract, Reflect) {
    for (const Scalar shininess : {32.0f, 0.5f})
        for (const int lights : {0, 1, 3})
            for (const bool parallel : {false, true})
                for (const bool grey : {false, true}) {
                    const Lit lit(shininess, parallel, lights, grey);
                    same({.function = Function::Reflect, .surface = lit.surface}, usual_cases / 8);
                }
}

TEST_P(Contract, ReflectFace) {
    Lit lit(7);
    for (const bool two_sided : {false, true})
        for (const bool mirrored : {false, true}) {
            lit.surface.two_sided = two_sided;
            const Setting setting{
                .function = Function::ReflectFace, .surface = lit.surface, .mirrored = mirrored};
            same(setting, usual_cases / 16);
            same(setting, usual_cases / 16, [](Random& random, auto in, int row) {  // many equal coordinates
                for (int k = 0; k < 10; ++k) in[k][row] = bits(static_cast<float>(random.integer(-1, 1)));
            });
        }
}

TEST_P(Contract, ClipCodes) {
    same({.function = Function::ClipCodes}, usual_cases);
    same({.function = Function::ClipCodes}, usual_cases / 4, [](Random& random, auto in, int row) {
        const float w = random.coin() ? 1.0f : static_cast<float>(random.unit());
        for (int k = 0; k < 4; ++k) {
            const float at[] = {
                0, w, -w, 7 * w, -7 * w, std::nextafter(w, 2.0f), std::nextafter(7 * w, 0.0f)};
            in[k][row] = bits(at[random.integer(0, 6)]);
        }
        in[3][row] = bits(w);
    });
}

TEST_P(Contract, WindowWithTies) {
    for (const auto& [width, height] : {std::pair{512, 256}, {8192, 8192}, {641, 479}, {1, 1}})
        same({.function = Function::Window, .viewport = {width, height}}, usual_cases / 4,
             [width = width](Random& random, auto in, int row) {
                 float p[4];
                 switch (random.integer(0, 2)) {
                     case 0:  // halfway between subpixels
                         p[3] = std::ldexp(1.0f, static_cast<int>(random.integer(-20, 20)));
                         p[0] = p[3] * static_cast<float>(2 * random.integer(-3000, 3000) + 1) /
                                static_cast<float>(256 * width);
                         p[1] = -p[0], p[2] = 0;
                         break;
                     case 1:
                         for (float& x : p) x = any_number(random);
                         break;
                     default:
                         p[3] = std::abs(random.any_finite_float());
                         for (int k = 0; k < 3; ++k)
                             p[k] =
                                 static_cast<float>(p[3] * random.between(k == 2 ? 0 : -7, k == 2 ? 1 : 7));
                 }
                 if (pipeline::clip_codes({{p[0], p[1], p[2], p[3]}}) != 0) p[0] = p[1] = p[2] = 0, p[3] = 1;
                 for (int k = 0; k < 4; ++k) in[k][row] = bits(p[k]);
             });
}

TEST_P(Contract, TrianglesAndTheirInterpolators) {
    same({.function = Function::Triangle}, usual_cases / 2, [](Random& random, auto in, int row) {
        for (int corner = 0; corner < 12; corner += 4) {
            in[corner][row] = whole(random, 1 << 23), in[corner + 1][row] = whole(random, 1 << 23);
            in[corner + 2][row] = bits(static_cast<float>(random.unit()));
            in[corner + 3][row] = bits(std::abs(random.any_finite_float()));
        }
        const auto at = [&](int k) {
            return raster::SnappedCorner{static_cast<std::int32_t>(in[k][row]),
                                         static_cast<std::int32_t>(in[k + 1][row]), 0, 0};
        };
        const std::int64_t area = raster::area2(at(0), at(4), at(8));
        if (area < 0) std::swap(in[4][row], in[8][row]), std::swap(in[5][row], in[9][row]);
        if (area == 0) in[0][row] = in[1][row] = in[5][row] = in[8][row] = 0, in[4][row] = in[9][row] = 1;
    });
}

TEST_P(Contract, DepthAndPerspectiveWeights) {
    same({.function = Function::Depth}, usual_cases, [](Random& random, auto in, int row) {
        for (int k = 0; k < 6; ++k) in[k][row] = whole(random, 1 << 24);
        for (int k = 6; k < 12; ++k) in[k][row] = bits(any_number(random));
    });
}

TEST_P(Contract, Interpolate) {
    same({.function = Function::Interpolate, .row = {0.1f, -3, 1e10f}}, usual_cases);
}

TEST_P(Contract, TexelPositions) {
    for (const int size : {1, 2, 3, 640, 427, 16384})
        same({.function = Function::TexelPosition, .size = size}, usual_cases / 4);
}

TEST_P(Contract, Samples) {
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 2}, {5, 3}, {640, 427}, {16384, 1}, {1, 16384}})
        for (const bool brightest : {false, true}) {
            const Texture texture = random_texture(width, height, brightest);
            for (const Filter filter : {Filter::Nearest, Filter::Bilinear}) {
                Setting setting{.function = Function::Sample};
                setting.surface.texture = &texture, setting.surface.filter = filter;
                same(setting, usual_cases / 16);
            }
        }
}

TEST_P(Contract, OutputAtEveryIntervalsEnds) {
    std::vector<float> ends;
    for (int k = 0; k < 256; ++k)
        for (const float end : {raster::srgb_thresholds[k], (static_cast<float>(k) + 0.5f) / 255,
                                static_cast<float>(k) / 255, static_cast<float>(k) / 256})
            for (const float toward : {-1.0f, 2.0f})
                ends.push_back(end), ends.push_back(std::nextafter(end, toward));
    for (const auto output : {raster::Output::Raw, raster::Output::Srgb}) {
        const Setting setting{.function = Function::Output, .output = output};
        same(setting, usual_cases);
        same(setting, usual_cases / 4, [&](Random& random, auto in, int row) {
            in[0][row] = bits(ends[std::size_t(row) % ends.size()]);
            in[1][row] = bits(ends[std::size_t(random.integer(0, std::int64_t(ends.size()) - 1))]);
            in[2][row] = bits(static_cast<float>(random.unit()));
        });
    }
}

TEST_P(Contract, ProgramsAtCornersAndPixels) {
    const Lit lit(32);
    for (const Function function : {Function::Corner, Function::Pixel})
        for (int program = 0; program < 8; ++program)
            same({.function = function, .surface = lit.surface, .program = program}, usual_cases / 16);
}

// The packed form is the plain one's bytes.
TEST(ContractPlain, PackedRgba8IsRgba8) {
    Random random(2);
    for (int i = 0; i < 100000; ++i)
        for (const auto output : {raster::Output::Raw, raster::Output::Srgb}) {
            const LinearRgb c{any_number(random), any_number(random), any_number(random)};
            ASSERT_EQ(std::bit_cast<std::uint32_t>(to_rgba8(c, output)), raster::packed_rgba8(c, output));
        }
}

}  // namespace
}  // namespace relevo::tests
