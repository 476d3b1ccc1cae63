#include "raster/interpolate.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

#include "pipeline/projection.hpp"
#include "tests/support/drawing.hpp"
#include "tests/support/exact_rational.hpp"
#include "tests/support/hard.hpp"

namespace relevo::raster {
namespace {

namespace exact = tests::exact;
namespace hard = tests::hard;

// Half an ulp of 1: the relative error of one rounding.
constexpr double u = std::numeric_limits<Scalar>::epsilon() / 2;
constexpr bool in_float = sizeof(Scalar) == 4;

// A triangle in the window with what its corners carry. The references compute with 64-bit significands (the
// error of one float rounding is 2^40 times larger), and a sample of them is checked in rational numbers.
struct Case {
    std::array<exact::Site, 3> site;
    std::array<Scalar, 3> z, w, a;
    int x, y;  // the pixel
};

struct Drawn {  // what the machine makes of it
    bool covered = false;
    Scalar z = 0, a = 0;
};

Drawn machine(const Case& c) {
    SnappedCorner corner[3];
    for (std::size_t i = 0; i < 3; ++i)
        corner[i] = {static_cast<std::int32_t>(c.site[i].x), static_cast<std::int32_t>(c.site[i].y), c.z[i],
                     1 / c.w[i]};
    const std::int64_t area = area2(corner[0], corner[1], corner[2]);
    if (area == 0) return {};
    const auto [order] = canonical_order(corner[0], corner[1], corner[2], area > 0);
    const Triangle t = make_triangle(corner[order[0]], corner[order[1]], corner[order[2]]);
    const EdgeValues e = edge_values(t, c.x, c.y);
    if (!is_covered(t, e)) return {};
    const Interpolator interpolator = make_interpolator(t);
    const VaryingPlane<1> plane = make_plane<1>({c.a[std::size_t(order[0])]}, {c.a[std::size_t(order[1])]},
                                                {c.a[std::size_t(order[2])]});
    return {true, depth(interpolator, e), interpolate(plane, perspective_weights(interpolator, e))[0]};
}

long double reference(const Case& c, const std::array<Scalar, 3>& value, bool perspective) {
    const exact::Site p = exact::centre(c.x, c.y);
    long double sum = 0, whole = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const exact::Site a = c.site[(i + 1) % 3], b = c.site[(i + 2) % 3];
        long double share = static_cast<long double>((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
        if (perspective) share /= static_cast<long double>(c.w[i]);
        sum += share * static_cast<long double>(value[i]), whole += share;
    }
    return sum / whole;
}

exact::Rational rational_reference(const Case& c, const std::array<Scalar, 3>& value, bool perspective) {
    std::array<exact::Rational, 3> v, factor;
    for (std::size_t i = 0; i < 3; ++i) {
        v[i] = exact::Rational(value[i]);
        factor[i] = perspective ? 1 / exact::Rational(c.w[i]) : exact::Rational(1);
    }
    return exact::interpolated(c.site, exact::centre(c.x, c.y), v, factor);
}

double largest(const std::array<Scalar, 3>& a) {
    return std::max({std::abs(static_cast<double>(a[0])), std::abs(static_cast<double>(a[1])),
                     std::abs(static_cast<double>(a[2]))});
}

// |z - plane| in units of u max|z_i|; the promise is 2 units (2^-23 max|z_i|).
double depth_units(const Case& c, const Drawn& drawn) {
    const double unit = u * largest(c.z);
    return unit == 0 ? 0 : static_cast<double>(std::abs(drawn.z - reference(c, c.z, false))) / unit;
}
// |a - exact| as a share of what is allowed, 8 u max|a_i| + 2 u |a|.
double perspective_share(const Case& c, const Drawn& drawn) {
    const long double right = reference(c, c.a, true);
    const double allowed = 8 * u * largest(c.a) + 2 * u * static_cast<double>(std::abs(right));
    return allowed == 0 ? 0 : static_cast<double>(std::abs(drawn.a - right)) / allowed;
}
constexpr double depth_promise = in_float ? 2 : 8;  // in double, the gradients round like everything else
constexpr double perspective_promise = in_float ? 1 : 2;

// --------------------------------------------------------------------------------------------- the cases
std::array<exact::Site, 3> shape(hard::Random& r, int kind) {
    const auto box = [&](std::int64_t low, std::int64_t high) {
        const auto s = [&] { return exact::Site{r.integer(low, high), r.integer(low, high)}; };
        return std::array<exact::Site, 3>{s(), s(), s()};
    };
    switch (kind) {
        case 0:
            return box(0, 640 * 256);
        case 1:
            return box(0, 8192 * 256);
        case 2:
            return box(-(1 << 22), (1 << 22) + (1 << 21));
        case 3:
            return box(4000 * 256, 4004 * 256);
        default: {  // slivers and needles up to 8192 pixels long, 1/256 to 1 pixel wide
            const pipeline::Degrees angle{r.between(0, 360)};
            const double dx = pipeline::cos(angle), dy = pipeline::sin(angle), length = r.between(1000, 1e6),
                         width = r.between(1, kind == 4 ? 256 : 4), along = r.between(-1, 1) * length,
                         x = r.between(0, 8192 * 256), y = r.between(0, 8192 * 256);
            const auto site = [](double px, double py) {
                return exact::Site{std::llround(px), std::llround(py)};
            };
            return {site(x - length * dx, y - length * dy), site(x + length * dx, y + length * dy),
                    site(x + along * dx - width * dy, y + along * dy + width * dx)};
        }
    }
}
constexpr int shapes = 6;
constexpr const char* shape_names[shapes] = {"640 px", "8192 px", "guard band", "4 px", "slivers", "needles"};

std::array<Scalar, 3> some_depths(hard::Random& r) {
    std::array<Scalar, 3> z;
    const auto kind = r.integer(0, 4);
    for (Scalar& v : z) {
        const double d = kind == 0   ? r.unit()
                         : kind == 1 ? (r.coin() ? 0 : 1 - 0.1 * r.unit())
                         : kind == 2 ? 1 - 1e-4 * r.unit()
                         : kind == 3 ? pipeline::exp2(-30 * r.unit())
                                     : (r.integer(0, 2) ? r.unit() : 0);
        v = static_cast<Scalar>(static_cast<float>(d));
    }
    return z;
}

// A pixel of the triangle: near a random point of it, often near a corner.
void choose_pixel(hard::Random& r, Case& c) {
    double a = r.unit(), b = r.unit();
    if (a + b > 1) a = 1 - a, b = 1 - b;
    if (r.coin()) a *= a * a, b *= b;
    const auto at = [&](auto member) {
        const auto m = [&](std::size_t i) { return static_cast<double>(c.site[i].*member); };
        return static_cast<int>(std::floor((m(0) + a * (m(1) - m(0)) + b * (m(2) - m(0))) / 256));
    };
    c.x = at(&exact::Site::x), c.y = at(&exact::Site::y);
}

Case some_case(hard::Random& r, int kind, double w_ratio) {
    Case c{shape(r, kind), some_depths(r), {}, {}, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        c.w[i] = static_cast<Scalar>(0.3 * pipeline::exp2(pipeline::log2(w_ratio) * r.unit()));
        c.a[i] = static_cast<Scalar>(r.integer(0, 3) ? r.between(-1, 1) : (r.coin() ? 1 : -1));
    }
    c.w[std::size_t(r.integer(0, 2))] = Scalar(0.3);
    c.w[std::size_t(r.integer(0, 2))] = static_cast<Scalar>(0.3 * w_ratio);
    choose_pixel(r, c);
    return c;
}

// ---------------------------------------------------------------------------------------------- the tests
TEST(Interpolate, AConstantComesOutExactlyConstant) {
    hard::Random r(1);
    int pixels = 0;
    for (int i = 0; i < 100'000; ++i) {
        Case c = some_case(r, i % shapes, pipeline::exp2(r.between(0, 20)));
        c.z.fill(static_cast<Scalar>(static_cast<float>(r.unit())));
        c.a.fill(static_cast<Scalar>(r.any_finite_float()));
        for (int k = 0; k < 3; ++k, choose_pixel(r, c)) {
            const Drawn drawn = machine(c);
            if (!drawn.covered) continue;
            ++pixels;
            ASSERT_EQ(drawn.z, c.z[0]);
            ASSERT_EQ(drawn.a, c.a[0]);
        }
    }
    EXPECT_GT(pixels, 100'000);
}

TEST(Interpolate, DepthIsTheSnappedPlaneWithinItsPromise) {
    for (int kind = 0; kind < shapes; ++kind) {
        hard::Random r(static_cast<std::uint64_t>(100 + kind));
        double worst = 0;
        std::int64_t pixels = 0;
        for (int i = 0; i < hard::cases(400'000); ++i) {
            const Case c = some_case(r, kind, 1);
            const Drawn drawn = machine(c);
            if (!drawn.covered) continue;
            ++pixels;
            worst = std::max(worst, depth_units(c, drawn));
        }
        std::printf("depth, %-10s: %7lld pixels, largest error %.3f x 2^-24 max|z|\n", shape_names[kind],
                    static_cast<long long>(pixels), worst);
        EXPECT_GT(pixels, 1000);
        EXPECT_LE(worst, depth_promise) << shape_names[kind];
    }
}

TEST(Interpolate, PerspectiveIsWithinItsPromiseUpToAThousandToOne) {
    for (const double ratio : {1.0, 2.0, 10.0, 100.0, 1000.0}) {
        double worst = 0;
        std::int64_t pixels = 0;
        hard::Random r(static_cast<std::uint64_t>(ratio));
        for (int i = 0; i < hard::cases(200'000); ++i) {
            const Case c = some_case(r, static_cast<int>(i % 3), ratio);
            const Drawn drawn = machine(c);
            if (!drawn.covered) continue;
            ++pixels;
            worst = std::max(worst, perspective_share(c, drawn));
        }
        std::printf("perspective, w ratio %4.0f: %7lld pixels, largest error %.3f of what is allowed\n",
                    ratio, static_cast<long long>(pixels), worst);
        EXPECT_GT(pixels, 10'000);
        EXPECT_LE(worst, perspective_promise) << ratio;
    }
}

// Climbing towards larger errors, from many starts: what random cases do not find.
template <class Measure>
double climb(std::uint64_t seed, int starts, int steps, Measure measure) {
    hard::Random r(seed);
    const auto shaken = [&](Scalar v) {
        return static_cast<Scalar>(static_cast<double>(v) *
                                   (1 + r.between(-0.5, 0.5) * (r.coin() ? 1e-6 : 0.3)));
    };
    double best = 0;
    for (int s = 0; s < starts; ++s) {
        Case top = some_case(r, static_cast<int>(r.integer(0, 2)), 1000);
        double height = -1;
        for (int i = 0; i < steps; ++i) {
            Case c = height < 0 ? some_case(r, static_cast<int>(r.integer(0, 2)), 1000) : top;
            const auto k = static_cast<std::size_t>(r.integer(0, 2));
            const std::int64_t reach = r.coin() ? 3 : 3000;
            switch (r.integer(0, 5)) {
                case 0:
                    c.site[k].x += r.integer(-reach, reach);
                    break;
                case 1:
                    c.site[k].y += r.integer(-reach, reach);
                    break;
                case 2:
                    c.z[k] = std::min<Scalar>(1, shaken(c.z[k]));
                    break;
                case 3:
                    c.w[k] = std::clamp<Scalar>(shaken(c.w[k]), Scalar(0.3), 300);
                    break;
                case 4:
                    c.a[k] = shaken(c.a[k]);
                    break;
                default:
                    c.x += static_cast<int>(r.integer(-3, 3)), c.y += static_cast<int>(r.integer(-3, 3));
            }
            if (std::abs(c.site[k].x) > 1 << 23 || std::abs(c.site[k].y) > 1 << 23) continue;
            const Drawn drawn = machine(c);
            if (!drawn.covered) continue;
            const double error = measure(c, drawn);
            if (error >= height) top = c, height = error;
        }
        best = std::max(best, height);
    }
    return best;
}

TEST(Interpolate, ClimbingFindsNoErrorBeyondThePromises) {
    const double z = climb(21, hard::cases(30), 20'000, depth_units),
                 a = climb(22, hard::cases(60), 20'000, perspective_share);
    std::printf("climbing: depth %.3f x 2^-24 max|z|, perspective %.3f of what is allowed\n", z, a);
    EXPECT_LE(z, depth_promise);
    EXPECT_LE(a, perspective_promise);
}

// Found by climbing: they break the promises when weights or depth are summed in float.
TEST(Interpolate, TheWorstKnownCasesKeepThePromises) {
    const Case depth_case{{{{109231, 52439}, {146636, 117869}, {89171, 152408}}},
                          {Scalar(0x1.03ee1cp-3), Scalar(0x1.54653ap-18), Scalar(0x1.9fb0aep-30)},
                          {1, 1, 1},
                          {0, 0, 0},
                          570,
                          457};
    const Case uv_case{{{{772529, 1666191}, {117143, 1045921}, {1234149, 1343698}}},
                       {0, 0, 0},
                       {Scalar(0x1.00e782p+4), Scalar(0x1.36f4c8p+9), Scalar(0x1.7256c2p+5)},
                       {Scalar(-0x1.260088p-2), Scalar(0x1.27b616p-2), Scalar(0x1.95a95ap-4)},
                       2488,
                       5478};
    EXPECT_LE(depth_units(depth_case, machine(depth_case)), depth_promise);
    EXPECT_LE(perspective_share(uv_case, machine(uv_case)), perspective_promise);
}

TEST(Interpolate, TheReferencesAreRightInRationalNumbers) {
    hard::Random r(5);
    int checked = 0;
    for (int i = 0; checked < 400; ++i) {
        const Case c = some_case(r, i % shapes, 1000);
        if (!machine(c).covered) continue;
        ++checked;
        const auto off = [&](const std::array<Scalar, 3>& v, bool perspective) {
            const exact::Rational right = rational_reference(c, v, perspective);
            return std::abs(static_cast<double>(exact::Rational(reference(c, v, perspective)) - right)) /
                   std::max(largest(v), 1e-30);
        };
        ASSERT_LT(off(c.z, false), 0x1p-58);
        ASSERT_LT(off(c.a, true), 0x1p-58);
    }
}

TEST(Interpolate, HugeAndTinyWStayInRange) {
    hard::Random r(6);
    int pixels = 0;
    for (int i = 0; i < 20'000; ++i) {
        Case c = some_case(r, i % 3, 100);
        const Scalar k = static_cast<Scalar>(pipeline::exp2(static_cast<double>(r.integer(-110, 110))));
        for (Scalar& w : c.w) w *= k;
        const Drawn drawn = machine(c);
        if (!drawn.covered) continue;
        ++pixels;
        ASSERT_LE(perspective_share(c, drawn), perspective_promise) << "w about " << c.w[0];
    }
    EXPECT_GT(pixels, 3000);
}

// ------------------------------------------------------------------------------- a floor to the horizon
// How well the stored depth tells distances apart, by decade: the relative error of the distance read back
// from it, against the plane through the snapped corners.
struct DecadeTable {
    static constexpr int decades = 6;
    double worst[decades] = {};
    std::int64_t pixels[decades] = {};
    std::vector<SnappedCorner> corner;
    DepthFormat format;

    void add(const DepthTested& e) {
        std::array<exact::Site, 3> site;
        std::array<Scalar, 3> z;
        for (std::size_t i = 0; i < 3; ++i) site[i] = {corner[i].x, corner[i].y}, z[i] = corner[i].z;
        const Case c{site, z, {1, 1, 1}, {0, 0, 0}, e.x, e.y};
        const auto distance = [&](long double d) {  // near 0.1, far infinite
            return 0.1L / (format == DepthFormat::Float32Reversed ? d : 1 - d);
        };
        const long double right = distance(reference(c, c.z, false)), got = distance(e.z);
        const int decade = static_cast<int>(std::floor(std::log10(static_cast<double>(right)))) + 1;
        if (decade < 0 || decade >= decades) return;
        ++pixels[decade];
        worst[decade] = std::max(worst[decade], static_cast<double>(std::abs(got - right) / right));
    }
};

DecadeTable floor_to_the_horizon(DepthFormat format) {
    pipeline::Mesh mesh =
        tests::mesh_of({{{{-1e6f, -0.317f, -1e6f}, {0, -0.317f, 1}, {1e6f, -0.317f, -1e6f}}}});
    Scene scene;
    scene.models.push_back({&mesh, {}, {}, nullptr, false});
    const auto range = format == DepthFormat::Float32Reversed ? pipeline::DepthRange::Reversed
                                                              : pipeline::DepthRange::Forward;
    scene.camera.clip_from_eye =
        *pipeline::perspective({90}, 16 / 8192.0, 0.1, std::numeric_limits<double>::infinity(), range);
    Settings settings = tests::unlit();
    settings.depth = format;
    Frame frame = tests::frame_of(16, 8192);
    DecadeTable table;
    table.format = format;
    tests::Watch watch(16, 8192);
    watch.on_snapped = [&](const TriangleSnapped& e) {
        table.corner.assign(std::begin(e.corners), std::end(e.corners));
    };
    watch.on_depth = [&](const DepthTested& e) { table.add(e); };
    tests::draw_watched(scene, settings, frame, watch);
    return table;
}

TEST(Interpolate, ReversedDepthResolvesTheFloorToTheHorizon) {
    const DecadeTable reversed = floor_to_the_horizon(DepthFormat::Float32Reversed),
                      forward = floor_to_the_horizon(DepthFormat::Float32Forward);
    std::printf(
        "dz/z on a floor, near 0.1, far infinite, 8192 rows\n  distance          float32 reversed   float32 "
        "forward\n");
    for (int d = 0; d < DecadeTable::decades; ++d) {
        if (reversed.pixels[d] == 0) continue;
        std::printf("  1e%+d .. 1e%+d          %.1e           %.1e   (%lld pixels)\n", d - 1, d,
                    reversed.worst[d], forward.worst[d], static_cast<long long>(forward.pixels[d]));
        EXPECT_LT(reversed.worst[d], in_float ? 1e-6 : 1e-12) << "decade " << d - 1;
        if (d >= 3 && in_float) {
            EXPECT_GT(forward.worst[d], 1e-5) << "the other format must show its loss";
        }
    }
    EXPECT_GT(reversed.pixels[4], 0);
}

}  // namespace
}  // namespace relevo::raster
