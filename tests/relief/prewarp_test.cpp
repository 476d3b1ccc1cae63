#include "relief/prewarp.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <iterator>
#include <tuple>

#include "relief/resample_asymmetric.hpp"
#include "relief/resample_compensated.hpp"
#include "tests/relief/random_source.hpp"

namespace relevo::relief {
namespace {

namespace hard = tests::hard;

constexpr Resampler all_resamplers[] = {Resampler::Splat,       Resampler::OneDimensional,
                                        Resampler::Asymmetric,  Resampler::Compensated,
                                        Resampler::Interleaved, Resampler::Mesh};
const char* name(Resampler resampler) {
    constexpr const char* names[] = {"splat",       "one-dimensional", "asymmetric",
                                     "compensated", "interleaved",     "mesh"};
    return names[static_cast<int>(resampler)];
}

// Blots of surface with holes, at depths that jump or not.
ReliefTexture blots(hard::Random& r, const ReliefCamera& camera, double depth_low, double depth_high,
                    double covered = 0.7) {
    ReliefTexture texture = make_relief_texture(camera);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            texture.coverage.at(x, y) = r.unit() < covered;
            texture.color.at(x, y) = {Scalar(r.unit()), Scalar(r.unit()), Scalar(r.unit())};
            texture.normal.at(x, y) = Vec3(glm::dvec3(r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)));
            texture.depth.at(x, y) = static_cast<Scalar>(r.between(depth_low, depth_high));
            if (!texture.coverage.at(x, y)) texture.depth.at(x, y) = std::numeric_limits<Scalar>::quiet_NaN();
        }
    return texture;
}
// A surface that rolls or leaps from texel to texel, with holes; or falls over cliffs every 16 texels; or
// rounds off at its outlines, like balls or like pipes, that begin where a block begins after an empty one.
ReliefTexture landscape(hard::Random& r, const ReliefCamera& camera) {
    enum Form { Rolls, Leaps, Cliffs, Balls, Pipes };
    const Form form = static_cast<Form>(r.integer(0, 4));
    ReliefTexture texture = make_relief_texture(camera);
    const double holes = form == Leaps   ? 0.5
                         : form == Rolls ? 0.05
                                         : 0,
                 phase = r.between(0, 6), deep = r.between(0.05, 3);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const double u = (x % 64 - 19.3) / 20, v = form == Pipes ? 0 : (y % 40 - 19.6) / 20,
                         hump = 1 - u * u - v * v;
            if (r.unit() < holes || (form >= Balls && hump < 0)) continue;
            const double height = form == Rolls ? 0.5 + 0.5 * std::sin(phase + 0.05 * x) * std::cos(0.04 * y)
                                  : form == Leaps  ? r.unit()
                                  : form == Cliffs ? x / 16 % 2
                                                   : 1 - std::sqrt(hump);
            const double d = deep * height;
            texture.coverage.at(x, y) = 1;
            texture.color.at(x, y) = {Scalar(x), Scalar(y), Scalar(d)};
            texture.depth.at(x, y) =
                static_cast<Scalar>(camera.projection == Projection::Perspective ? 1 / (1 + d) : d);
        }
    return texture;
}
ReliefCamera front(int width, int height) {
    return *orthographic_camera({{0, 0, -1}, {0, 1, 0}, width, height}, {0, 0, 1}, 2);
}
Viewer somewhere(hard::Random& r, const ReliefCamera& camera) {
    return viewer_at(random::viewer_place(r, camera, r.between(0.5, 4), 3));
}

template <class Pixel>
bool same_bytes(const Image<Pixel>& a, const Image<Pixel>& b) {
    return a.pixels().size() == b.pixels().size() &&
           std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size() * sizeof(Pixel)) == 0;
}
// The maps only where both have them.
bool same_bytes(const Prewarped& a, const Prewarped& b) {
    const bool maps = !a.kind.empty() && !b.kind.empty();
    return same_bytes(a.color, b.color) && same_bytes(a.normal, b.normal) && same_bytes(a.depth, b.depth) &&
           same_bytes(a.coverage, b.coverage) &&
           (!maps ||
            (same_bytes(a.source, b.source) && same_bytes(a.kind, b.kind) && same_bytes(a.writes, b.writes)));
}

bool same(const LinearRgb& a, const LinearRgb& b) { return a == b; }
bool same(const Vec3& a, const Vec3& b) { return a == b; }

void expect_copy(const Prewarped& got, const ReliefTexture& source, const char* what, bool depths) {
    for (int y = 0; y < source.camera.height; ++y)
        for (int x = 0; x < source.camera.width; ++x) {
            const int wx = x - got.window.x0, wy = y - got.window.y0;
            ASSERT_EQ(got.coverage.at(wx, wy), source.coverage.at(x, y)) << what << ' ' << x << ' ' << y;
            if (!source.coverage.at(x, y)) continue;
            ASSERT_TRUE(same(got.color.at(wx, wy), source.color.at(x, y))) << what << ' ' << x << ' ' << y;
            ASSERT_TRUE(same(got.normal.at(wx, wy), source.normal.at(x, y))) << what << ' ' << x << ' ' << y;
            if (depths) {
                ASSERT_EQ(got.depth.at(wx, wy), source.depth.at(x, y)) << what;
            }
            if (got.kind.empty()) continue;
            ASSERT_EQ(got.kind.at(wx, wy), Kind::Sampled) << what << ' ' << x << ' ' << y;
            ASSERT_EQ(got.source.at(wx, wy), Vec2(Scalar(x + 0.5), Scalar(y + 0.5))) << what;
        }
}

TEST(Prewarp, WithoutDisplacementTheOutputIsTheSourceToTheBit) {
    hard::Random r(1);
    for (int i = 0; i < 12; ++i) {
        const ReliefCamera camera = front(int(r.integer(1, 40)), int(r.integer(1, 40)));
        const ReliefTexture texture = blots(r, camera, 0, 0);
        const Warp warp = *make_warp(camera, somewhere(r, camera));
        for (const Resampler resampler : all_resamplers)
            for (const bool maps : {false, true}) {
                PrewarpSettings settings;
                settings.resampler = resampler, settings.maps = maps;
                expect_copy(prewarp(texture, warp, source_window(camera), settings), texture, name(resampler),
                            true);
            }
    }
}

TEST(Prewarp, SeenFromTheSourceTheOutputIsTheSourceToTheBit) {
    hard::Random r(2);
    for (int i = 0; i < 12; ++i) {
        const int width = int(r.integer(1, 40)), height = int(r.integer(1, 40));
        // an orthographic source's own viewer is at infinity
        const ReliefCamera orthographic = front(width, height),
                           perspective = *perspective_camera({{1, 2, -3}, {0, 1, 0}, width, height},
                                                             {0.5, 1, 2}, 1.5, {60});
        const ReliefTexture shear = blots(r, orthographic, 0, 2), cone = blots(r, perspective, 0.1, 1);
        const Warp shear_warp = *make_warp(orthographic, viewer_toward({0, 0, 1})),
                   cone_warp = *make_warp(perspective, viewer_at(perspective.eye));
        for (const Resampler resampler : all_resamplers)
            for (const Jump jump : {Jump::Skin, Jump::Cut}) {
                PrewarpSettings settings;
                settings.resampler = resampler, settings.jump = jump, settings.maps = true;
                expect_copy(prewarp(shear, shear_warp, source_window(orthographic), settings), shear,
                            name(resampler), true);
                expect_copy(prewarp(cone, cone_warp, source_window(perspective), settings), cone,
                            name(resampler), false);
            }
    }
}

// A slanted plane fills a polygon that is known: every resampler but the splats gives at every pixel
// inside what the plane has there.
TEST(Prewarp, ASlantedPlaneComesOutAsTheProjectionOfThePlane) {
    hard::Random r(3);
    for (int i = 0; i < 8; ++i) {
        const bool perspective = i % 2 == 1;
        const ReliefCamera camera =
            perspective ? *perspective_camera({{0, 0, -1}, {0, 1, 0}, 64, 48}, {0, 0, 2}, 1, {50})
                        : front(64, 48);
        // the plane n.(X - p) = 0, behind the picture's
        const glm::dvec3 p(0, 0, -0.5), n(r.between(-0.4, 0.4), r.between(-0.4, 0.4), 1);
        ReliefTexture texture = make_relief_texture(camera);
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) {
                const SourceRay ray = source_ray(camera, x + 0.5, y + 0.5);
                const double t = glm::dot(p - ray.origin, n) / glm::dot(ray.direction, n);
                texture.depth.at(x, y) = static_cast<Scalar>(perspective ? 1 / t : t);
                texture.coverage.at(x, y) = 1;
                const glm::dvec3 at = ray.origin + t * ray.direction;
                texture.color.at(x, y) = {Scalar(at.x), Scalar(at.y), Scalar(at.z)};
            }
        ASSERT_FALSE(refusal(texture));
        const glm::dvec3 eye(r.between(-1, 1), r.between(-1, 1), 3);
        const Warp warp = *make_warp(camera, viewer_at(eye));
        const Window window = *target_window(camera, warp, depth_range(texture));
        for (const Resampler resampler : all_resamplers) {
            if (resampler == Resampler::Splat) continue;
            PrewarpSettings settings;
            settings.resampler = resampler, settings.maps = true;
            const Prewarped got = prewarp(texture, warp, window, settings);
            int inside = 0;
            double worst = 0, worst_depth = 0;
            for (int y = 0; y < window.height; ++y)
                for (int x = 0; x < window.width; ++x) {
                    const glm::dvec3 q = plane_point(camera, x + window.x0 + 0.5, y + window.y0 + 0.5);
                    const double t = glm::dot(p - eye, n) / glm::dot(q - eye, n);
                    const glm::dvec3 right = eye + t * (q - eye);
                    const glm::dvec2 from = {got.source.at(x, y).x, got.source.at(x, y).y};
                    if (!got.coverage.at(x, y) || from.x < 1 || from.x > 63 || from.y < 1 || from.y > 47)
                        continue;
                    ++inside;
                    const LinearRgb& c = got.color.at(x, y);
                    worst = std::max({worst, std::abs(double(c.r) - right.x), std::abs(double(c.g) - right.y),
                                      std::abs(double(c.b) - right.z)});
                    const double depth = glm::dot(right - camera.corner, forward(camera));
                    worst_depth = std::max(worst_depth, std::abs(double(got.depth.at(x, y)) - depth));
                }
            EXPECT_GT(inside, 500) << name(resampler);
            // a texel is 0.04 wide; the linear displacement of the one-dimensional one is 0.002 to 0.04
            // texel off
            const double bound = resampler == Resampler::OneDimensional ? 1e-3
                                 : resampler == Resampler::Mesh         ? 2e-4
                                                                        : 2e-5;
            EXPECT_LT(worst, bound) << name(resampler) << (perspective ? " perspective" : " orthographic");
            EXPECT_LT(worst_depth, bound) << name(resampler);
        }
    }
}

// Compensation, (8-1) of the thesis and the row that is carried along are one and the same; the printed
// form fails on the row of the epipole.
TEST(Prewarp, DisplacementCompensationIsPerspectiveInterpolation) {
    hard::Random r(4);
    double worst = 0, worst_row = 0;
    for (int i = 0; i < 20'000; ++i) {
        const ReliefCamera camera = front(64, 64);
        const Warp warp = *make_warp(camera, somewhere(r, camera));
        const double v = r.between(0, 64), e_v = warp.k2 / warp.k3;
        if (std::abs(v - e_v) < 1) continue;
        const Displacement a{Scalar(r.between(0, 2))}, b{Scalar(r.between(0, 2))};
        const WarpedPoint at_a = warp_point(warp, 10.5, v, a), at_b = warp_point(warp, 11.5, v, b);
        const double t = r.unit(), row = (1 - t) * at_a.v + t * at_b.v,
                     d = compensated_depth(double(a.value), at_a.weight, double(b.value), at_b.weight, t);
        worst = std::max(worst, std::abs(d - compensated_depth_by_row(warp, v, at_a.v, at_b.v, t)));
        worst_row = std::max(worst_row, std::abs((v + warp.k2 * d) / (1 + warp.k3 * d) - row));
    }
    EXPECT_LE(worst, 1e-9);
    EXPECT_LE(worst_row, 1e-9);
    // on the epipole's row the row does not move, so (8-1) is 0 / 0
    const ReliefCamera camera = front(64, 64);
    const Warp warp = *make_warp(camera, viewer_at(plane_point(camera, 20, 32) + glm::dvec3(0, 0, 2)));
    EXPECT_FALSE(std::isfinite(compensated_depth_by_row(warp, 32, 32, 32, 0.3)));
    EXPECT_NEAR(compensated_depth(0.5, 0.8, 1, 2.0 / 3, 0.3), (0.7 * 0.4 + 0.3 * 2 / 3) / (0.7 * 0.8 + 0.2),
                1e-15);
}

TEST(Prewarp, ThreadsAndMapsChangeNoByte) {
    hard::Random r(5);
    for (int i = 0; i < 4; ++i) {
        const ReliefCamera camera = front(97, 71);
        const ReliefTexture texture = blots(r, camera, 0, i < 2 ? 0.2 : 1.5);
        const Warp warp = *make_warp(camera, somewhere(r, camera));
        const auto window = target_window(camera, warp, depth_range(texture));
        ASSERT_TRUE(window);
        for (const Resampler resampler : all_resamplers) {
            PrewarpSettings settings;
            settings.resampler = resampler;
            const Prewarped one = prewarp(texture, warp, *window, settings);
            for (const auto& [threads, maps] : {std::pair(2, false), {3, true}, {5, false}}) {
                settings.threads = threads, settings.maps = maps;
                const Prewarped many = prewarp(texture, warp, *window, settings);
                EXPECT_TRUE(same_bytes(one, many)) << name(resampler) << ' ' << threads;
            }
        }
    }
}

// Where bands of columns meet, sheets that fold over one another, from all sides, reach into both. One memory
// serves warps that have nothing to do with one another.
TEST(Prewarp, BandsOfColumnsChangeNoByte) {
    hard::Random r(77);
    PrewarpMemory memory;
    for (int i = 0; i < 24; ++i) {
        const Projection projection = i % 2 ? Projection::Perspective : Projection::Orthographic;
        const ReliefCamera camera = random::source(r, projection);
        ReliefTexture texture = landscape(r, camera);
        if (i == 7) texture.depth.at(0, 0) = std::numeric_limits<Scalar>::quiet_NaN();
        const glm::dvec3 eye =
            random::viewer_place(r, camera, std::pow(10, r.between(-3, 3)), r.between(0, 5));
        const auto warp = make_warp(camera, viewer_at(eye));
        ASSERT_TRUE(warp);
        auto window = target_window(camera, *warp, depth_range(texture));
        if (!window || window->width > 400 || window->height > 400) window = source_window(camera);
        for (const Jump jump : {Jump::Skin, Jump::Cut}) {
            const PreparedRelief relief = prepare(texture, jump);
            for (const Resampler resampler : {Resampler::OneDimensional, Resampler::Asymmetric,
                                              Resampler::Compensated, Resampler::Interleaved}) {
                PrewarpSettings settings;
                settings.resampler = resampler, settings.maps = i % 3 == 0, settings.depth_test = i % 5 == 0;
                Prewarped one, many;
                prewarp(relief, *warp, *window, settings, one, memory);
                for (const int threads : {2, 3, 7}) {
                    settings.threads = threads;
                    prewarp(relief, *warp, *window, settings, many, memory);
                    ASSERT_TRUE(same_bytes(one, many)) << i << ' ' << name(resampler) << ' ' << threads;
                }
            }
        }
    }
}

// A band of one column at every place: of each row it gets what the whole window gets there, no more, no
// less.
TEST(Prewarp, ABandGetsTheSamplesOfItsColumns) {
    hard::Random r(78);
    const std::unique_ptr<WarpedRow> row = make_warped_row();
    for (int i = 0; i < 200; ++i) {
        const ReliefCamera camera =
            random::source(r, i % 2 ? Projection::Perspective : Projection::Orthographic);
        const PreparedRelief relief = prepare(landscape(r, camera), i % 4 < 2 ? Jump::Skin : Jump::Cut);
        const auto warp =
            make_warp(camera, viewer_at(random::viewer_place(r, camera, std::pow(10, r.between(-1, 1)), 3)));
        ASSERT_TRUE(warp);
        const Window window = source_window(camera);
        struct Sample {
            int x;
            Scalar v, weight, depth;
            bool operator==(const Sample&) const = default;
        };
        const int y = static_cast<int>(r.integer(0, camera.height - 1));
        const auto samples_of = [&](const Band& band) {
            std::vector<Sample> samples;
            row->y = -1;
            warp_row(relief, *warp, window, band, y, *row);
            resample_row<false, AsymmetricMethod>(
                relief, *row, DepthWarp(*warp), occlusion_order(*warp), window, band,
                [&](int x, auto&& sample) {
                    const RowSample<false> s = sample();
                    samples.push_back({x, s.v, s.weight, s.carried.depth()});
                });
            return samples;
        };
        const std::vector<Sample> all = samples_of(whole(window));
        for (int x = 0; x < window.width; ++x) {
            std::vector<Sample> here;
            std::copy_if(all.begin(), all.end(), std::back_inserter(here),
                         [&](const Sample& sample) { return sample.x == x; });
            ASSERT_TRUE(samples_of({x, x + 1}) == here) << "case " << i << " row " << y << " column " << x;
        }
    }
}

TEST(Prewarp, AFilledPictureIsFilledAgainWithoutATrace) {
    hard::Random r(6);
    const ReliefCamera camera = front(40, 30);
    const PreparedRelief one = prepare(blots(r, camera, 0, 1)), two = prepare(blots(r, camera, 0, 1));
    const Warp warp = *make_warp(camera, viewer_at({0.3, 0.2, 4}));
    PrewarpSettings settings;
    settings.maps = true;
    Prewarped reused, fresh;
    prewarp(one, warp, source_window(camera), settings, reused);
    prewarp(two, warp, source_window(camera), settings, reused);
    prewarp(two, warp, source_window(camera), settings, fresh);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            ASSERT_EQ(reused.coverage.at(x, y), fresh.coverage.at(x, y));
            ASSERT_EQ(reused.kind.at(x, y), fresh.kind.at(x, y));
            ASSERT_EQ(reused.writes.at(x, y), fresh.writes.at(x, y));
            if (fresh.coverage.at(x, y)) {
                ASSERT_EQ(reused.color.at(x, y), fresh.color.at(x, y));
            }
        }
}

// Two plates, one 0.5 deeper, side by side or one above the other: a skin joins them, a cut parts them.
TEST(Prewarp, ASkinOrACutAcrossAJump) {
    const ReliefCamera camera = front(64, 64);
    for (const bool stacked : {false, true}) {
        ReliefTexture texture = make_relief_texture(camera);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const bool far = (stacked ? y : x) < 32;
                texture.coverage.at(x, y) = 1;
                texture.depth.at(x, y) = far ? Scalar(0.5) : 0;
                texture.color.at(x, y) = far ? LinearRgb{1, 0, 0} : LinearRgb{0, 0, 1};
            }
        // the viewer beyond the near plate: the far one moves under it; beyond the far one: a gap opens
        for (const bool gap : {false, true}) {
            const double aside = gap ? -40 : 104;
            const glm::dvec3 foot = plane_point(camera, stacked ? 32 : aside, stacked ? aside : 32);
            const Warp warp = *make_warp(camera, viewer_at(foot + glm::dvec3(0, 0, 3)));
            const Window window = *target_window(camera, warp, depth_range(texture));
            for (const Resampler resampler : all_resamplers) {
                if (resampler == Resampler::Splat) continue;
                PrewarpSettings settings;
                settings.resampler = resampler, settings.maps = true;
                const Prewarped skin = prewarp(texture, warp, window, settings);
                settings.jump = Jump::Cut;
                const Prewarped cut = prewarp(texture, warp, window, settings);
                int across = 0, only_in_skin = 0, mixed_in_cut = 0;
                for (int y = 0; y < window.height; ++y)
                    for (int x = 0; x < window.width; ++x) {
                        const int along = stacked ? x : y;
                        if (along < 8 || along >= (stacked ? window.width : window.height) - 8) continue;
                        across += skin.kind.at(x, y) == Kind::FilledAcross;
                        only_in_skin += skin.coverage.at(x, y) && !cut.coverage.at(x, y);
                        const LinearRgb& c = cut.color.at(x, y);
                        mixed_in_cut += cut.coverage.at(x, y) && c.r > Scalar(0.01) && c.b > Scalar(0.01);
                    }
                EXPECT_EQ(mixed_in_cut, 0) << name(resampler) << stacked;
                if (gap) {  // 10 texels: (32 + 40) 0.5 / 3.5
                    EXPECT_GT(across, 40 * 8) << name(resampler) << stacked;
                    EXPECT_GT(only_in_skin, 40 * 8) << name(resampler) << stacked;
                } else {
                    EXPECT_EQ(only_in_skin, 0) << name(resampler) << stacked;
                }
            }
        }
    }
}

TEST(Prewarp, ExtremesAreRightOrRefused) {
    hard::Random r(7);
    // one texel; one row; one column; nothing
    for (const auto& [width, height] : {std::pair(1, 1), {9, 1}, {1, 9}, {5, 5}}) {
        const ReliefCamera camera = front(width, height);
        const bool nothing = width == 5;
        const ReliefTexture texture = blots(r, camera, 0.5, 0.5, nothing ? 0 : 2);
        const Warp warp = *make_warp(camera, viewer_at({0.2, 0.1, 3}));
        const Window window = *target_window(camera, warp, depth_range(texture));
        for (const Resampler resampler : all_resamplers)
            for (const Jump jump : {Jump::Skin, Jump::Cut}) {
                PrewarpSettings settings;
                settings.resampler = resampler, settings.jump = jump;
                const Prewarped got = prewarp(texture, warp, window, settings);
                int covered = 0;
                for (const auto c : got.coverage.pixels()) covered += c;
                const double weight = 2 / 2.5, area = weight * weight * width * height;
                if (nothing)
                    EXPECT_EQ(covered, 0);
                else
                    EXPECT_NEAR(covered, area, 1.01 * std::max(width, height)) << name(resampler);
                if (!nothing) {
                    EXPECT_GE(covered, 1) << name(resampler) << ' ' << width << ' ' << height;
                }
            }
    }
    // viewers at the end of the world, epipoles on texels and beyond everything: nothing breaks, all in
    // window
    const ReliefCamera camera = front(32, 24);
    const ReliefTexture texture = blots(r, camera, 0, 1.5);
    for (const double h : {1e-6, 0.5, 1e9})
        for (const double e_u : {-1e9, 0.0, 16.5, 20.25, 1e9})
            for (const double e_v : {12.5, 12.0, -1e9}) {
                const auto warp =
                    make_warp(camera, viewer_at(plane_point(camera, e_u, e_v) + glm::dvec3(0, 0, h)));
                ASSERT_TRUE(warp);
                const auto window = target_window(camera, *warp, depth_range(texture));
                for (const Resampler resampler : all_resamplers) {
                    PrewarpSettings settings;
                    settings.resampler = resampler, settings.maps = true;
                    const Prewarped got =
                        prewarp(texture, *warp, window ? *window : source_window(camera), settings);
                    if (!window) continue;  // refused; cut to the square all the same, without a fault
                    for (int y = 0; y < got.window.height; ++y)
                        for (int x = 0; x < got.window.width; ++x) {
                            if (!got.coverage.at(x, y)) continue;
                            ASSERT_TRUE(std::isfinite(got.color.at(x, y).r));
                            ASSERT_GE(got.depth.at(x, y), 0);
                            ASSERT_LE(got.depth.at(x, y), Scalar(4.51));
                        }
                }
            }
}

}  // namespace
}  // namespace relevo::relief
