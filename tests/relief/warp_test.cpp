#include "relief/warp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "relief/warp_3d.hpp"
#include "tests/relief/random_source.hpp"

namespace relevo::relief {
namespace {

namespace hard = tests::hard;

// The line from the viewer to X, cut with the plane: no formula of the warp in it.
struct Direct {
    double u, v, weight;
};
Direct project(const ReliefCamera& camera, const Viewer& viewer, const glm::dvec3& x) {
    const glm::dvec3 f = forward(camera), t(viewer.place);
    const bool far = viewer.place.w == 0;
    const glm::dvec3 sight = far ? t : t - x;
    const double behind = glm::dot(x - camera.corner, f), rise = -glm::dot(sight, f);
    const glm::dvec3 on_plane = x + (behind / rise) * sight - camera.corner;
    const double aa = glm::dot(camera.a, camera.a), bb = glm::dot(camera.b, camera.b),
                 ab = glm::dot(camera.a, camera.b), pa = glm::dot(on_plane, camera.a),
                 pb = glm::dot(on_plane, camera.b), area = aa * bb - ab * ab;
    const double h = glm::dot(camera.corner - t, f);
    return {(pa * bb - pb * ab) / area, (pb * aa - pa * ab) / area, far ? 1 : h / (h + behind)};
}

struct Case {
    ReliefCamera camera;
    Viewer viewer;
    double u, v;
    Displacement d;
    Disparity q;
};
WarpedPoint warped(const Warp& warp, const Case& c) {
    return warp.projection == Projection::Orthographic ? warp_point(warp, c.u, c.v, c.d)
                                                       : warp_point(warp, c.u, c.v, c.q);
}
glm::dvec3 point(const Case& c) {
    return c.camera.projection == Projection::Orthographic ? world_point(c.camera, c.u, c.v, c.d)
                                                           : world_point(c.camera, c.u, c.v, c.q);
}
Case some_case(hard::Random& r, bool skewed) {
    Case c;
    c.camera = random::source(r, r.coin() ? Projection::Orthographic : Projection::Perspective);
    if (skewed) c.camera.b = c.camera.b + r.between(-0.8, 0.8) * c.camera.a;
    const double h = r.between(0.2, 8);
    const glm::dvec3 place = random::viewer_place(r, c.camera, h, 6);
    c.viewer = r.integer(0, 7) == 0 ? viewer_toward(place - plane_point(c.camera, 3, 4)) : viewer_at(place);
    c.u = r.between(0, c.camera.width), c.v = r.between(0, c.camera.height);
    c.d = random::displacement(r), c.q = random::disparity(r);
    return c;
}

double off(const WarpedPoint& p, const Direct& right) {
    const double scale = std::max({1.0, std::abs(right.u), std::abs(right.v)});
    return std::max({std::abs(p.u - right.u), std::abs(p.v - right.v), std::abs(p.weight - right.weight)}) /
           scale;
}

TEST(Warp, BothFormsAgreeWithProjectionInSpace) {
    hard::Random r(1);
    double worst_products = 0, worst_axes = 0, largest = 0;
    for (int i = 0; i < hard::cases(20'000); ++i) {
        const Case c = some_case(r, false);
        const auto products = make_warp(c.camera, c.viewer), axes = make_warp_along_axes(c.camera, c.viewer);
        ASSERT_TRUE(products && axes);
        const Direct right = project(c.camera, c.viewer, point(c));
        worst_products = std::max(worst_products, off(warped(*products, c), right));
        worst_axes = std::max(worst_axes, off(warped(*axes, c), right));
        largest = std::max(largest, std::abs(right.u));
    }
    std::printf("of up to %.0f texels: triple products %.1e, along the axes %.1e\n", largest, worst_products,
                worst_axes);
    EXPECT_LE(worst_products, 1e-9);
    EXPECT_LE(worst_axes, 1e-9);
}

TEST(Warp, SkewedTexelsNeedTheTripleProducts) {
    hard::Random r(2);
    for (int i = 0; i < hard::cases(5000); ++i) {
        const Case c = some_case(r, true);
        const auto products = make_warp(c.camera, c.viewer);
        ASSERT_TRUE(products);
        EXPECT_LE(off(warped(*products, c), project(c.camera, c.viewer, point(c))), 1e-9);
        ASSERT_FALSE(make_warp_along_axes(c.camera, c.viewer));
        EXPECT_NE(make_warp_along_axes(c.camera, c.viewer).error().message.find("skewed"), std::string::npos);
    }
}

TEST(Warp, UnwarpUndoesIt) {
    hard::Random r(3);
    for (int i = 0; i < hard::cases(5000); ++i) {
        const Case c = some_case(r, i % 2 == 0);
        const Warp warp = *make_warp(c.camera, c.viewer);
        const WarpedPoint p = warped(warp, c);
        const glm::dvec2 back = warp.projection == Projection::Orthographic
                                    ? unwarp_point(warp, p.u, p.v, c.d)
                                    : unwarp_point(warp, p.u, p.v, c.q);
        EXPECT_NEAR(back.x, c.u, 1e-9 * std::max(1.0, std::abs(p.u)));
        EXPECT_NEAR(back.y, c.v, 1e-9 * std::max(1.0, std::abs(p.v)));
    }
}

TEST(Warp, TheInverseIsAStraightLineTowardsTheEpipole) {
    hard::Random r(4);
    for (int i = 0; i < 2000; ++i) {
        Case c = some_case(r, false);
        if (c.viewer.place.w == 0 || c.camera.projection == Projection::Perspective) continue;
        const Warp warp = *make_warp(c.camera, c.viewer);
        const glm::dvec2 e(warp.k1 / warp.k3, warp.k2 / warp.k3), at(c.u, c.v),
            line = at + double{c.d.value} * warp.k3 * (at - e), got = unwarp_point(warp, c.u, c.v, c.d);
        const double scale = std::max({1.0, std::abs(e.x), std::abs(e.y)});
        EXPECT_LE(std::max(std::abs(got.x - line.x), std::abs(got.y - line.y)), 1e-9 * scale);
    }
}

// The general three-dimensional warp is the pre-warp and then the homography of the plane.
TEST(Warp, TheGeneralWarpFactorsIntoPrewarpAndHomography) {
    hard::Random r(5);
    double worst = 0;
    int seen = 0;
    for (int i = 0; i < hard::cases(20'000); ++i) {
        Case c = some_case(r, i % 3 == 0);
        if (c.viewer.place.w == 0) continue;
        // a target camera at the viewer's place that looks at about the middle of the source
        const glm::dvec3 eye(c.viewer.place),
            middle = plane_point(c.camera, 0.5 * c.camera.width, 0.5 * c.camera.height);
        const auto target =
            perspective_camera({middle + random::place(r, 0.3) - eye, random::place(r), 512, 512}, eye,
                               r.between(0.5, 3), {r.between(20, 90)});
        if (!target) continue;
        const Warped3d whole = c.camera.projection == Projection::Orthographic
                                   ? warp_3d(c.camera, c.u, c.v, c.d, *target)
                                   : warp_3d(c.camera, c.u, c.v, c.q, *target);
        if (whole.z < 0.05) continue;  // beside or behind the target's eye
        const WarpedPoint p = warped(*make_warp(c.camera, c.viewer), c);
        const glm::dvec3 x = plane_homography(c.camera, *target) * glm::dvec3(p.u, p.v, 1);
        const double scale = std::max({512.0, std::abs(whole.u), std::abs(whole.v)});
        worst =
            std::max({worst, std::abs(x.x / x.z - whole.u) / scale, std::abs(x.y / x.z - whole.v) / scale});
        // and the depth along the target's axis grows by h + d over h, the warp's weight
        worst = std::max(worst, std::abs(x.z / p.weight - whole.z) / whole.z);
        ++seen;
    }
    std::printf("homography after pre-warp: within %.1e of the picture over %d points\n", worst, seen);
    EXPECT_GT(seen, 5000);
    EXPECT_LE(worst, 1e-9);
}

TEST(Warp, AViewerAtTheSourceMovesNothing) {
    hard::Random r(6);
    for (int i = 0; i < 500; ++i) {
        const ReliefCamera perspective = random::source(r, Projection::Perspective),
                           orthographic = random::source(r, Projection::Orthographic);
        for (const auto& warp : {*make_warp(perspective, viewer_at(perspective.eye)),
                                 *make_warp_along_axes(perspective, viewer_at(perspective.eye))}) {
            EXPECT_LE(std::abs(warp.k3), 1e-15);
            EXPECT_LE(std::abs(warp.k1) + std::abs(warp.k2), 1e-9);
        }
        // bit for bit where no subtraction stands between: the constants of the triple products are 0
        const Warp exact = *make_warp(perspective, viewer_at(perspective.eye));
        EXPECT_EQ(exact.k1, 0);
        EXPECT_EQ(exact.k2, 0);
        EXPECT_EQ(exact.k3, 0);
        const Warp shear = *make_warp(orthographic, viewer_toward(-forward(orthographic)));
        EXPECT_EQ(shear.k3, 0);
        EXPECT_LE(std::abs(shear.k1) + std::abs(shear.k2), 1e-10);
    }
    // the orthographic source along an axis of the world, its viewer at infinity
    const ReliefCamera front = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 64, 64}, {0, 0, 1}, 2);
    const Warp none = *make_warp(front, viewer_toward({0, 0, 1}));
    EXPECT_EQ(none.k1, 0);
    EXPECT_EQ(none.k2, 0);
    EXPECT_EQ(none.k3, 0);
}

TEST(Warp, TheEpipoleStaysAtEveryDepth) {
    hard::Random r(7);
    for (int i = 0; i < 1000; ++i) {
        const Case c = some_case(r, false);
        if (c.viewer.place.w == 0) continue;
        const Warp warp = *make_warp(c.camera, c.viewer);
        Case at = c;
        at.u = warp.k1 / warp.k3, at.v = warp.k2 / warp.k3;
        const WarpedPoint p = warped(warp, at);
        const double scale = std::max({1.0, std::abs(at.u), std::abs(at.v)});
        EXPECT_NEAR(p.u, at.u, 1e-9 * scale);
        EXPECT_NEAR(p.v, at.v, 1e-9 * scale);
    }
}

TEST(Warp, ExtremesOfHeightAndEpipole) {
    const ReliefCamera camera = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 256, 256}, {0, 0, 0}, 2);
    for (const double h : {1e-6, 1e9})
        for (const double e : {-1e9, 0.0, 100.5, 128.25, 1e9}) {
            const glm::dvec3 eye = plane_point(camera, e, 37) - h * forward(camera);
            const auto warp = make_warp(camera, viewer_at(eye));
            ASSERT_TRUE(warp);
            for (const double u : {0.5, 100.5, 255.5}) {
                const Scalar d = 1.25;
                const WarpedPoint p = warp_point(*warp, u, 37, Displacement{d});
                // a convex combination of place and epipole
                const double w = h / (h + double{d}), right = w * u + (1 - w) * e;
                EXPECT_NEAR(p.u, right, 1e-9 * std::max(1.0, std::abs(e))) << h << ' ' << e;
                EXPECT_NEAR(p.v, 37, 1e-7);
                EXPECT_NEAR(p.weight, w, 1e-12);
            }
        }
}

TEST(Warp, AViewerOnOrBehindThePlaneIsRefused) {
    const ReliefCamera camera = *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 16, 16}, {0, 0, 1}, 2);
    constexpr double nan_of = std::numeric_limits<double>::quiet_NaN();
    for (const Viewer& viewer :
         {viewer_at({0.3, 0.2, 1}), viewer_at({0, 0, 0.92}), viewer_at({5, 0, -3}), viewer_toward({0, 0, -1}),
          viewer_toward({1, 0, 0}), viewer_at({nan_of, 0, 3}), viewer_at({0, 0, 1 / 0.0})}) {
        EXPECT_FALSE(make_warp(camera, viewer));
        EXPECT_FALSE(make_warp_along_axes(camera, viewer));
    }
    EXPECT_TRUE(make_warp(camera, viewer_at({0.3, 0.2, 1.000001})));
}

}  // namespace
}  // namespace relevo::relief
