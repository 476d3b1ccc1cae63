#include "raster/texture.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "raster/output.hpp"
#include "tests/support/exact_rational.hpp"
#include "tests/support/hard.hpp"

namespace relevo::raster {
namespace {

namespace hard = tests::hard;
using tests::exact::Integer;
using tests::exact::Rational;

// Every texel another colour, which tells its place.
Texture numbered(int width, int height) {
    std::vector<std::uint8_t> rgb;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int v : {x & 255, (height - 1 - y) & 255, (x >> 8) + 16 * ((height - 1 - y) >> 8)})
                rgb.push_back(static_cast<std::uint8_t>(v));
    return make_texture(width, height, 3, rgb, Encoding::Raw);
}
struct Texel {
    int x, y;
};
Texel texel_of(LinearRgb c) {
    const auto byte = [](Scalar v) { return static_cast<int>(std::lround(static_cast<double>(v) * 255)); };
    return {byte(c.r) + 256 * (byte(c.b) % 16), byte(c.g) + 256 * (byte(c.b) / 16)};
}

Integer floor_of(const Rational& r) {
    Integer q = numerator(r) / denominator(r);
    if (Rational(q) > r) --q;
    return q;
}
// The texel that holds u of a repeated image, and how far it is from that texel's borders (in texels).
struct Exact {
    int texel;
    double to_border;
};
Exact exact_texel(Scalar u, int size) {
    const Rational position = Rational(u) * size;
    const Integer texel = floor_of(position);
    const Rational inside = position - Rational(texel);
    Integer wrapped = texel % size;
    if (wrapped < 0) wrapped += size;
    return {static_cast<int>(wrapped), static_cast<double>(std::min(inside, Rational(1 - inside)))};
}

TEST(Texture, TheLowerLeftCornerIsTheOrigin) {
    const Texture t = numbered(4, 3);
    EXPECT_EQ(texel_of(sample_nearest(t, {Scalar(0.01), Scalar(0.01)})).x, 0);
    EXPECT_EQ(texel_of(sample_nearest(t, {Scalar(0.01), Scalar(0.01)})).y, 0);
    EXPECT_EQ(texel_of(sample_nearest(t, {Scalar(0.99), Scalar(0.99)})).x, 3);
    EXPECT_EQ(texel_of(sample_nearest(t, {Scalar(0.99), Scalar(0.99)})).y, 2);
}

TEST(Texture, NearestIsTheExactTexelAwayFromItsBorders) {
    hard::Random r(1);
    for (const int size : {1, 2, 3, 5, 64, 1000, 4096}) {
        const Texture wide = numbered(size, 1), high = numbered(1, size);
        for (int i = 0; i < 2000; ++i) {
            const auto u = static_cast<Scalar>(static_cast<float>(r.between(-3, 3)));
            const Exact right = exact_texel(u, size);
            if (right.to_border < 1.0 / 512) continue;
            ASSERT_EQ(texel_of(sample_nearest(wide, {u, 0})).x, right.texel) << u << " of " << size;
            ASSERT_EQ(texel_of(sample_nearest(high, {0, u})).y, right.texel) << u << " of " << size;
        }
    }
}

TEST(Texture, EveryTexelIsReachedAtItsCentre) {
    const Texture t = numbered(37, 23);
    for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 37; ++x)
            for (const int turn : {-2, 0, 1})
                for (const Filter filter : {Filter::Nearest, Filter::Bilinear}) {
                    const Vec2 uv{static_cast<Scalar>((x + 0.5) / 37 + turn),
                                  static_cast<Scalar>((y + 0.5) / 23 - turn)};
                    const Texel got = texel_of(sample(t, filter, uv));
                    ASSERT_EQ(got.x, x);
                    ASSERT_EQ(got.y, y);
                }
}

TEST(Texture, BilinearIsTheExactBlendWithin1Of512OfTheContrast) {
    hard::Random r(2);
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 2}, {3, 5}, {16, 7}, {64, 64}}) {
        std::vector<std::uint8_t> rgb;
        for (int i = 0; i < width * height * 3; ++i) rgb.push_back(r.coin() ? 255 : 0);
        const Texture t = make_texture(width, height, 3, rgb, Encoding::Raw);
        const auto texel = [&, width = width, height = height](std::int64_t x, std::int64_t y, int c) {
            const auto wrap = [](std::int64_t v, int n) { return std::size_t((v % n + n) % n); };
            return t.texels[wrap(y, height) * std::size_t(width) + wrap(x, width)][std::size_t(c)] / 255.0;
        };
        for (int i = 0; i < 4000; ++i) {
            const Vec2 uv{static_cast<Scalar>(static_cast<float>(r.between(-2, 2))),
                          static_cast<Scalar>(static_cast<float>(r.between(-2, 2)))};
            const double px = static_cast<double>(uv.x) * width - 0.5,
                         py = static_cast<double>(uv.y) * height - 0.5;
            const double fx = px - std::floor(px), fy = py - std::floor(py);
            const auto x = static_cast<std::int64_t>(std::floor(px)),
                       y = static_cast<std::int64_t>(std::floor(py));
            const LinearRgb got = sample_bilinear(t, uv);
            const Scalar channel[3] = {got.r, got.g, got.b};
            for (int c = 0; c < 3; ++c) {
                const double right = (1 - fy) * ((1 - fx) * texel(x, y, c) + fx * texel(x + 1, y, c)) +
                                     fy * ((1 - fx) * texel(x, y + 1, c) + fx * texel(x + 1, y + 1, c));
                ASSERT_NEAR(static_cast<double>(channel[c]), right, 2.0 / 512 + 1e-4) << uv.x << "," << uv.y;
            }
        }
    }
}

TEST(Texture, AConstantTextureIsAConstantPicture) {
    hard::Random r(3);
    for (int value = 0; value < 256; ++value)
        for (const Encoding encoding : {Encoding::Raw, Encoding::Srgb}) {
            const std::vector<std::uint8_t> rgb(3 * 5 * 3, static_cast<std::uint8_t>(value));
            const Texture t = make_texture(5, 3, 3, rgb, encoding);
            const LinearRgb first = sample_nearest(t, {0, 0});
            for (int i = 0; i < 60; ++i) {
                const Vec2 uv{static_cast<Scalar>(r.between(-9, 9)), static_cast<Scalar>(r.between(-9, 9))};
                ASSERT_EQ(sample_nearest(t, uv), first);
                ASSERT_EQ(sample_bilinear(t, uv), first) << "the weights sum to one exactly";
                const Output output = encoding == Encoding::Raw ? Output::Raw : Output::Srgb;
                ASSERT_EQ(to_rgba8(sample_bilinear(t, uv), output).g, value)
                    << "and come back as they were stored";
            }
        }
}

TEST(Texture, RepeatedByWholeImages) {
    hard::Random r(4);
    const Texture t = numbered(8, 16);
    for (int i = 0; i < 5000; ++i) {
        // multiples of 2^-8 stay exact when whole images are added, up to 2^15
        const Vec2 uv{static_cast<Scalar>(static_cast<double>(r.integer(0, 255)) / 256),
                      static_cast<Scalar>(static_cast<double>(r.integer(0, 255)) / 256)};
        const Vec2 moved{uv.x + static_cast<Scalar>(r.integer(-32768, 32767)),
                         uv.y + static_cast<Scalar>(r.integer(-32768, 32767))};
        ASSERT_EQ(sample_nearest(t, uv), sample_nearest(t, moved));
        ASSERT_EQ(sample_bilinear(t, uv), sample_bilinear(t, moved));
    }
}

// Under the sanitizers this also says: no texel outside, no conversion out of range.
TEST(Texture, AnyCoordinateHasATexel) {
    constexpr Scalar nan = std::numeric_limits<Scalar>::quiet_NaN(),
                     inf = std::numeric_limits<Scalar>::infinity(), most = std::numeric_limits<Scalar>::max(),
                     least = std::numeric_limits<Scalar>::denorm_min();
    std::vector<Scalar> all = {Scalar(-1e-9),
                               Scalar(1e-9),
                               Scalar(1e30),
                               Scalar(-1e30),
                               nan,
                               inf,
                               -inf,
                               most,
                               -most,
                               least,
                               -least,
                               Scalar(0),
                               Scalar(-0.0),
                               Scalar(1),
                               Scalar(-1),
                               Scalar(0x1p23),
                               Scalar(0x1p31),
                               Scalar(1e10),
                               std::nextafter(Scalar(1), Scalar(0)),
                               std::nextafter(Scalar(0), Scalar(-1)),
                               Scalar(0.5)};
    hard::Random r(5);
    for (int i = 0; i < 300; ++i) all.push_back(static_cast<Scalar>(r.any_finite_float()));
    for (const auto& [width, height] :
         {std::pair{1, 1}, {1, 7}, {7, 1}, {2, 2}, {5, 3}, {max_texture_size, 1}, {1, max_texture_size}}) {
        const std::vector<std::uint8_t> rgb(std::size_t(width * height * 3), 255);
        const Texture t = make_texture(width, height, 3, rgb, Encoding::Raw);
        for (const Scalar u : all)
            for (const Scalar v : {u, Scalar(0.25), all[std::size_t(r.integer(0, 300))]}) {
                EXPECT_EQ(sample_nearest(t, {u, v}), sample_nearest(t, {0, 0})) << u << "," << v;
                EXPECT_EQ(sample_bilinear(t, {u, v}), sample_nearest(t, {0, 0})) << u << "," << v;
            }
        for (const Scalar u : all)
            for (const int size : {width, height}) {
                const TexelPosition p = texel_position(u, size);
                EXPECT_TRUE(0 <= p.low && p.low < size && 0 <= p.high && p.high < size && p.weight < 256)
                    << u << " of " << size;
                EXPECT_EQ(p.high, (p.low + 1) % size);
            }
    }
}

TEST(Texture, RowsComeTopFirstAndAlphaIsLeftOut) {
    const std::vector<std::uint8_t> rgba = {255, 0, 0,   1, 0,  255, 0,  2,   // top row: red, green
                                            0,   0, 255, 3, 51, 51,  51, 4};  // bottom row: blue, grey
    const Texture t = make_texture(2, 2, 4, rgba, Encoding::Raw);
    EXPECT_EQ(sample_nearest(t, {Scalar(0.25), Scalar(0.75)}), (LinearRgb{1, 0, 0}));
    EXPECT_EQ(sample_nearest(t, {Scalar(0.75), Scalar(0.75)}), (LinearRgb{0, 1, 0}));
    EXPECT_EQ(sample_nearest(t, {Scalar(0.25), Scalar(0.25)}), (LinearRgb{0, 0, 1}));
    EXPECT_EQ(to_rgba8(sample_nearest(t, {Scalar(0.75), Scalar(0.25)}), Output::Raw),
              (Rgba8{51, 51, 51, 255}));
}

}  // namespace
}  // namespace relevo::raster
