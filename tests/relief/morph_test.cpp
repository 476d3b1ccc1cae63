// Plain morphing, view morphing, optical flow.
#include "relief/morph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "relief/capture_raster.hpp"
#include "relief/error_set.hpp"
#include "relief/optical_flow.hpp"
#include "relief/ray_cast.hpp"
#include "relief/surface_checker_cube.hpp"
#include "relief/view_morph.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "samples/scene/shapes/torus.hpp"
#include "tests/relief/random_source.hpp"

namespace relevo::relief {
namespace {

// The square [-1, 1]^2 of the plane z = 0; its colour says where on it a point lies.
struct Ramp {};
std::optional<SurfaceHit> first_hit(const Ramp&, const Ray& ray) {
    const double t = -ray.origin.z / ray.direction.z;
    const glm::dvec3 p = ray.origin + t * ray.direction;
    if (!(t >= ray.from && std::fabs(p.x) <= 1 && std::fabs(p.y) <= 1)) return {};
    return SurfaceHit{t, {0, 0, 1}, {Scalar(0.5 + 0.5 * p.x), Scalar(0.5 + 0.5 * p.y), 0}};
}

ReliefCamera camera_round(double azimuth, double elevation, int size, double distance = 4) {
    using pipeline::Degrees;
    const Degrees a{azimuth}, e{elevation};
    const glm::dvec3 eye = distance * glm::dvec3(sin(a) * cos(e), sin(e), cos(a) * cos(e));
    return *perspective_camera({-eye, {0, 1, 0}, size, size}, eye, 1, {40});
}

struct Pair {
    ReliefTexture texture0, texture1;
    ViewImage view0, view1;
    Correspondence to1, to0;
    template <class Surface>
    Pair(const Surface& surface, const ReliefCamera& camera0, const ReliefCamera& camera1)
        : texture0(ray_cast(surface, camera0)),
          texture1(ray_cast(surface, camera1)),
          view0(as_seen(texture0)),
          view1(as_seen(texture1)),
          to1(true_correspondence(texture0, camera1)),
          to0(true_correspondence(texture1, camera0)) {}
    ViewImage plain(double s, double jump) const { return morph(view0, view1, to1, to0, s, jump); }
    ViewImage true_view(double s, double jump) const {
        return *view_morph(texture0.camera, view0, texture1.camera, view1, to1, to0, s, jump);
    }
};

// ---------------------------------------------------------------------------------------- correspondence
TEST(Correspondence, NamesTheSamePointOfTheWorld) {
    const Pair pair(scene::bumpy_object, camera_round(-20, 5, 64), camera_round(25, -10, 64));
    int known = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            if (!pair.to1.known.at(x, y)) continue;
            ++known;
            const ReliefCamera& other = pair.texture1.camera;
            const Vec2 there = pair.to1.place.at(x, y);
            const double depth = double{pair.to1.depth.at(x, y)};
            const glm::dvec3 sight = plane_point(other, double{there.x}, double{there.y}) - other.eye;
            const glm::dvec3 p = other.eye + sight * (depth / glm::dot(sight, forward(other)));
            EXPECT_LT(glm::length(p - world_point(pair.texture0, x, y)), 2e-5);
        }
    EXPECT_GT(known, 1000);
}

// ---------------------------------------------------------------------------------------- ends
template <class Morph>
void expect_ends(const Pair& pair, Morph&& morph_at) {
    for (const double s : {0.0, 1.0}) {
        const ViewImage got = morph_at(s);
        const ViewImage& right = s == 0 ? pair.view0 : pair.view1;
        const ErrorSet error = error_set(got, right);
        EXPECT_EQ(error.missing_percent, 0);
        EXPECT_LT(error.extra_percent, 3);  // borders are half a pixel wide
        int differ = 0;
        for (std::size_t i = 0; i < right.coverage.pixels().size(); ++i)
            differ += right.coverage.pixels()[i] &&
                      mean_square_difference(right.color.pixels()[i], got.color.pixels()[i]) > 1e-10;
        EXPECT_EQ(differ, 0);
    }
}
TEST(Morph, AtItsEndsIsTheTwoViews) {
    const Pair pair(Ramp{}, camera_round(-30, 10, 96), camera_round(30, -5, 96));
    expect_ends(pair, [&](double s) { return pair.plain(s, 1); });
    expect_ends(pair, [&](double s) { return pair.true_view(s, 1); });
}

TEST(Morph, WhereTheViewsShowDifferentSurfacesTheNearerOneStaysAlone) {
    const auto one_colour = [](LinearRgb color, Scalar depth) {
        ViewImage view(6, 6);
        for (std::size_t i = 0; i < 36; ++i)
            view.color.pixels()[i] = color, view.depth.pixels()[i] = depth, view.coverage.pixels()[i] = 1;
        return view;
    };
    const auto stays = [](Scalar depth) {
        Correspondence c{{6, 6}, {6, 6, depth}, {6, 6, 1}};
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 6; ++x) c.place.at(x, y) = Vec2(x + 0.5, y + 0.5);
        return c;
    };
    const LinearRgb red{1, 0, 0}, blue{0, 0, 1}, mixed{Scalar(0.75), 0, Scalar(0.25)};
    const auto middle = [&](Scalar depth0, Scalar depth1) {
        return morph(one_colour(red, depth0), one_colour(blue, depth1), stays(depth0), stays(depth1), 0.25,
                     0.1)
            .color.at(3, 3);
    };
    EXPECT_EQ(middle(1, 2), red);
    EXPECT_EQ(middle(2, 1), blue);
    EXPECT_EQ(middle(1, 1), mixed);
}

// ---------------------------------------------------------------------------------------- straight edges
// How far the line y = at of the ramp is from straight in the picture, in pixels: where each column crosses
// it, against the straight line through the first and the last such place; without the three at each end,
// where the border's pixels keep one colour to their last half.
double bend(const ViewImage& image, double at) {
    const double green = 0.5 + 0.5 * at;
    std::vector<glm::dvec2> places;
    for (int x = 0; x < image.width(); ++x)
        for (int y = 0; y + 1 < image.height(); ++y) {
            if (!image.coverage.at(x, y) || !image.coverage.at(x, y + 1)) continue;
            const double above = double{image.color.at(x, y).g}, below = double{image.color.at(x, y + 1).g};
            if ((above <= green) == (below <= green)) continue;
            places.emplace_back(x + 0.5, y + 0.5 + (green - above) / (below - above));
        }
    EXPECT_GT(places.size(), 60u);
    const glm::dvec2 first = places[3], way = places[places.size() - 4] - first;
    double most = 0;
    for (std::size_t k = 3; k + 3 < places.size(); ++k) {
        const glm::dvec2 p = places[k] - first;
        most = std::max(most, std::fabs(way.x * p.y - way.y * p.x) / glm::length(way));
    }
    return most;
}

TEST(ViewMorph, KeepsStraightEdgesStraightWherePlainMorphingBendsThem) {
    struct Row {
        double azimuth0, elevation0, azimuth1, elevation1, least_plain;
    };
    for (const auto& [azimuth0, elevation0, azimuth1, elevation1, least_plain] :
         {Row{-35, 0, 35, 0, 1}, Row{-50, 20, 40, -10, 2.5}, Row{-60, 45, 60, 45, 8}}) {
        const Pair pair(Ramp{}, camera_round(azimuth0, elevation0, 256),
                        camera_round(azimuth1, elevation1, 256));
        double plain = 0, true_view = 0;
        for (const double s : {0.25, 0.5, 0.75})
            for (const double at : {-0.8, 0.0, 0.8}) {
                plain = std::max(plain, bend(pair.plain(s, 1), at));
                true_view = std::max(true_view, bend(pair.true_view(s, 1), at));
            }
        std::printf(
            "views from %.0f, %.0f and %.0f, %.0f degrees: a straight edge bends by %.2f pixels, in the view "
            "morph by %.3f\n",
            azimuth0, elevation0, azimuth1, elevation1, plain, true_view);
        EXPECT_GT(plain, least_plain);
        EXPECT_LE(true_view, 0.1);
    }
}

TEST(ViewMorph, PointsAreWhereTheViewBetweenSeesThem) {
    tests::hard::Random r(5);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        const ReliefCamera camera0 = camera_round(r.between(-50, 0), r.between(-30, 30), 200),
                           camera1 = camera_round(r.between(1, 50), r.between(-30, 30), 200);
        const double s = r.between(0, 1);
        const auto maps = make_view_morph(camera0, camera1, s);
        ASSERT_TRUE(maps);
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 p = random::place(r, 0.6);
            const Warped3d at0 = warp_3d(p - camera0.eye, camera0), at1 = warp_3d(p - camera1.eye, camera1),
                           right = warp_3d(p - maps->between.eye, maps->between);
            const auto got = view_morph_point(*maps, {at0.u, at0.v}, {at1.u, at1.v});
            ASSERT_TRUE(got);
            worst = std::max({worst, std::fabs(got->u - right.u), std::fabs(got->v - right.v),
                              std::fabs(got->depth - view_depth(maps->between, p))});
        }
    }
    EXPECT_LT(worst, 1e-9);
}

TEST(ViewMorph, IsTheViewBetweenAndPlainMorphingIsNot) {
    struct Row {
        const char* name;
        double psnr, missing;
    };
    const ReliefCamera camera0 = camera_round(-20, 5, 256), camera1 = camera_round(20, 5, 256);
    const auto check = [&](const char* name, const auto& surface, double least, double more_than_plain,
                           double most_missing) {
        const Pair pair(surface, camera0, camera1);
        const ViewImage truth = ray_cast_view(surface, view_between(camera0, camera1, 0.5));
        const ErrorSet plain = error_set(pair.plain(0.5, 0.1), truth),
                       got = error_set(pair.true_view(0.5, 0.1), truth);
        std::printf(
            "%s, between 40 degrees: view morph %.2f dB, missing %.2f %%, depth %.4f; plain morph %.2f dB, "
            "missing %.2f %%\n",
            name, got.psnr, got.missing_percent, got.mean_depth_error, plain.psnr, plain.missing_percent);
        EXPECT_GT(got.psnr, least);
        EXPECT_GT(got.psnr, plain.psnr + more_than_plain);
        EXPECT_LT(got.missing_percent, most_missing);
        EXPECT_LT(got.mean_depth_error, 0.02);
    };
    check("sphere", scene::sphere_object, 25, 1, 1);
    check("bumpy", scene::bumpy_object, 20, 1, 2);
    check("checkered cube", CheckerCube{}, 15, 1, 2);
}

// Two views of a mesh from our own rasterizer, whose texels know their points as vertices know their numbers.
TEST(ViewMorph, OfAMeshIsWhatTheRasterizerDrawsBetween) {
    pipeline::Mesh torus = scene::torus_mesh(48, 24, 0.4);
    raster::Scene scene;
    raster::Model& model = scene.models.emplace_back();
    model.mesh = &torus, model.material.color = {Scalar(0.8), Scalar(0.5), Scalar(0.2)};
    scene.lights.push_back({});
    const raster::Settings lit{.shading = raster::Shading::Gouraud};
    const auto view = [&](const ReliefCamera& camera) { return *capture_raster(scene, camera, lit); };
    const ReliefCamera camera0 = camera_round(-15, 40, 200), camera1 = camera_round(15, 50, 200);
    const ReliefTexture texture0 = view(camera0), texture1 = view(camera1);
    const ViewImage truth = as_seen(view(view_between(camera0, camera1, 0.5)));
    const auto to1 = true_correspondence(texture0, camera1), to0 = true_correspondence(texture1, camera0);
    const ErrorSet got = error_set(*view_morph(camera0, as_seen(texture0), camera1, as_seen(texture1), to1,
                                               to0, 0.5, 0.1),
                                   truth),
                   plain = error_set(morph(as_seen(texture0), as_seen(texture1), to1, to0, 0.5, 0.1), truth);
    std::printf(
        "torus, a mesh: view morph %.2f dB, missing %.2f %%, depth %.4f; plain %.2f dB, missing %.2f %%\n",
        got.psnr, got.missing_percent, got.mean_depth_error, plain.psnr, plain.missing_percent);
    EXPECT_GT(got.psnr, plain.psnr + 5);
    EXPECT_LT(got.missing_percent, 0.5);
    EXPECT_LT(got.mean_depth_error, 0.005);
}

TEST(ViewMorph, RefusesWhatHasNoCommonPlane) {
    const ReliefCamera camera = camera_round(10, 0, 32);
    EXPECT_FALSE(make_view_morph(camera, camera, 0.5));
    ReliefCamera behind = camera;  // one step back: the eye lies in the other's picture
    behind.eye -= 0.5 * forward(camera), behind.corner -= 0.5 * forward(camera);
    EXPECT_FALSE(make_view_morph(camera, behind, 0.5));
    EXPECT_FALSE(make_view_morph(camera, camera_round(10 + 150, 0, 32), 0.5));
    EXPECT_FALSE(make_view_morph(camera, camera_round(10 + 180, 0, 32), 0.5));
    EXPECT_TRUE(make_view_morph(camera, camera_round(10 + 60, 0, 32), 0.5));
}

// ---------------------------------------------------------------------------------------- optical flow
TEST(OpticalFlow, FindsSmallMotionsAndLosesLargeOnes) {
    for (const auto& [degrees, most_mean, least_near] :
         {std::tuple(2.0, 0.2, 99.0), {5.0, 0.4, 90.0}, {10.0, 0.8, 75.0}, {25.0, 3.2, 50.0}}) {
        const Pair pair(scene::bumpy_object, camera_round(0, 0, 160), camera_round(degrees, 0, 160));
        const FlowError error =
            flow_error(pair.view0, pair.view1, pair.to1, optical_flow(pair.view0, pair.view1), Scalar(0.05));
        const double near_percent = 100.0 * error.near / error.known;
        std::printf("bumpy, %2.0f degrees: flow off by %.3f pixels, %.1f %% within one; known %.1f %%\n",
                    degrees, error.mean, near_percent, 100.0 * error.known / error.visible);
        EXPECT_LT(error.mean, most_mean);
        EXPECT_GT(near_percent, least_near);
    }
}

TEST(OpticalFlow, IsExactToAFewHundredthsOfAPixelWhereAPatternIsShifted) {
    // Waves of 33 and of 11 pixels: a shift by 13 is found only in the coarse pictures, where the short waves
    // are gone.
    const auto pattern = [](double u, double v) {
        using pipeline::Degrees;
        return Scalar(0.5 + 0.2 * sin(Degrees{11 * u + 5 * v}) + 0.2 * sin(Degrees{-4 * u + 13 * v}) +
                      0.08 * sin(Degrees{33 * u}) * sin(Degrees{33 * v}));
    };
    ViewImage from(120, 100), to(120, 100);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 120; ++x) {
            const Scalar a = pattern(x, y), b = pattern(x - 12.3, y + 3.8);
            from.color.at(x, y) = {a, a, a}, to.color.at(x, y) = {b, b, b};
            from.coverage.at(x, y) = to.coverage.at(x, y) = 1;
        }
    const auto worst = [&](const FlowSettings& settings) {
        const Correspondence flow = optical_flow(from, to, settings);
        double most = 0;
        for (int y = 30; y < 70; ++y)
            for (int x = 30; x < 90; ++x) {
                EXPECT_TRUE(flow.known.at(x, y));
                most = std::max(most, double{glm::length(flow.place.at(x, y) - Vec2(x + 12.8, y - 3.3))});
            }
        return most;
    };
    const double coarse_to_fine = worst({}), at_once = worst({.levels = 1});
    std::printf("a shifted pattern: off by at most %.4f pixels, %.1f without coarse pictures\n",
                coarse_to_fine, at_once);
    EXPECT_LT(coarse_to_fine, 0.05);
    EXPECT_GT(at_once, 2);
}

TEST(OpticalFlow, KnowsWhereItKnowsNothing) {
    ViewImage flat(40, 40), stripes(40, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            flat.coverage.at(x, y) = stripes.coverage.at(x, y) = 1;
            flat.color.at(x, y) = {Scalar(0.5), Scalar(0.5), Scalar(0.5)};
            const Scalar light =
                (x % 8 < 4 ? Scalar(0.9) : 0) + Scalar(0.002) * Scalar(y % 5);  // hardly more than stripes
            stripes.color.at(x, y) = {light, light, light};
        }
    for (const ViewImage* const view : {&flat, &stripes}) {
        const Correspondence flow = optical_flow(*view, *view);
        for (int y = 12; y < 28; ++y)
            for (int x = 12; x < 28; ++x) EXPECT_EQ(flow.known.at(x, y), 0);
    }
}

TEST(OpticalFlow, MorphsTwoPicturesOfWhichNothingElseIsKnown) {
    const Pair pair(scene::bumpy_object, camera_round(-5, 0, 160), camera_round(5, 0, 160));
    const ViewImage truth = ray_cast_view(scene::bumpy_object, camera_round(0, 0, 160));
    ViewImage faded(160, 160);  // without any correspondence: a double exposure
    for (std::size_t i = 0; i < faded.coverage.pixels().size(); ++i) {
        const LinearRgb a = pair.view0.color.pixels()[i], b = pair.view1.color.pixels()[i];
        faded.color.pixels()[i] = Scalar(0.5) * (a + b);
        faded.coverage.pixels()[i] = pair.view0.coverage.pixels()[i] | pair.view1.coverage.pixels()[i];
    }
    const auto there = optical_flow(pair.view0, pair.view1), back = optical_flow(pair.view1, pair.view0);
    const ErrorSet exposed = error_set(faded, truth),
                   flown = error_set(morph(pair.view0, pair.view1, there, back, 0.5, 0.2), truth),
                   known = error_set(pair.plain(0.5, 0.1), truth);
    std::printf(
        "bumpy, between 10 degrees: faded %.2f dB, bad %.2f %%; by flow %.2f, %.2f; by the true "
        "correspondence %.2f, %.2f\n",
        exposed.psnr, exposed.bad_percent, flown.psnr, flown.bad_percent, known.psnr, known.bad_percent);
    EXPECT_LT(flown.bad_percent, exposed.bad_percent / 2);
    EXPECT_LT(known.bad_percent, flown.bad_percent);
}

}  // namespace
}  // namespace relevo::relief
