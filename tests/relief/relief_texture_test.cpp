#include "relief/relief_texture.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace relevo::relief {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

double apart(const glm::dvec3& a, const glm::dvec3& b) { return std::sqrt(glm::dot(a - b, a - b)); }

TEST(ReliefTexture, TheAxesAreRightHandedAndRowZeroIsOnTop) {
    const ReliefCamera camera = *orthographic_camera({{0, 0, -2}, {0, 3, 0}, 4, 2}, {1, 2, 5}, 1);
    EXPECT_LT(apart(camera.corner, {0, 2.5, 5}), 1e-15);
    EXPECT_LT(apart(camera.a, {0.5, 0, 0}), 1e-15);
    EXPECT_LT(apart(camera.b, {0, -0.5, 0}), 1e-15);
    EXPECT_LT(apart(forward(camera), {0, 0, -1}), 1e-15);
    EXPECT_LT(apart(world_point(camera, 0.5, 0.5, Displacement{2}), {0.25, 2.25, 3}), 1e-15);
}

TEST(ReliefTexture, APerspectiveSourceHasDisparityOneOnItsPlane) {
    const ReliefCamera camera = *perspective_camera({{0, 0, -1}, {0, 1, 0}, 2, 2}, {0, 0, 4}, 3, {90});
    EXPECT_LT(apart(camera.corner, {-3, 3, 1}), 1e-14);
    EXPECT_LT(apart(world_point(camera, 0, 0, Disparity{1}), camera.corner), 1e-14);
    // twice as far from the eye: half the disparity
    EXPECT_LT(apart(world_point(camera, 0, 0, Disparity{0.5}), {-6, 6, -2}), 1e-14);
}

TEST(ReliefTexture, ASourceRayReachesTheWorldPoint) {
    for (const bool perspective : {false, true}) {
        const SourceView view{{1, -2, -3}, {0, 1, 0.5}, 8, 5};
        const ReliefCamera camera = perspective ? *perspective_camera(view, {1, 2, 3}, 2, {50})
                                                : *orthographic_camera(view, {1, 2, 3}, 2);
        const SourceRay ray = source_ray(camera, 3.5, 1.25);
        const glm::dvec3 x = perspective ? world_point(camera, 3.5, 1.25, Disparity{0.25})
                                         : world_point(camera, 3.5, 1.25, Displacement{4});
        EXPECT_LT(apart(ray.origin + 4.0 * ray.direction, x), 1e-13);
    }
}

TEST(ReliefTexture, ACameraThatCannotSeeIsRefused) {
    const SourceView view{{0, 0, -1}, {0, 1, 0}, 4, 4};
    EXPECT_TRUE(orthographic_camera(view, {0, 0, 0}, 1));
    EXPECT_FALSE(orthographic_camera(view, {0, 0, 0}, 0));
    EXPECT_FALSE(orthographic_camera(view, {0, 0, inf}, 1));
    EXPECT_FALSE(orthographic_camera({{0, 0, -1}, {0, 0, 5}, 4, 4}, {0, 0, 0}, 1));
    EXPECT_FALSE(orthographic_camera({{0, 0, -1}, {0, 1, 0}, 0, 4}, {0, 0, 0}, 1));
    EXPECT_FALSE(orthographic_camera({{0, 0, -1}, {0, 1, 0}, 4, 8193}, {0, 0, 0}, 1));
    EXPECT_FALSE(perspective_camera(view, {0, 0, 0}, -1, {60}));
    EXPECT_FALSE(perspective_camera(view, {0, 0, 0}, 1, {180}));
    ReliefCamera camera = *perspective_camera(view, {0, 0, 0}, 1, {60});
    EXPECT_FALSE(refusal(camera));
    camera.eye.z = -1;  // on the plane
    EXPECT_TRUE(refusal(camera));
}

TEST(ReliefTexture, AWrongDepthIsRefusedWithItsPlaceAndOnlyWhereTheTexelIsCovered) {
    ReliefTexture texture =
        make_relief_texture(*orthographic_camera({{0, 0, -1}, {0, 1, 0}, 4, 3}, {0, 0, 0}, 1));
    EXPECT_FALSE(refusal(texture));
    for (const Scalar wrong :
         {std::numeric_limits<Scalar>::quiet_NaN(), std::numeric_limits<Scalar>::infinity(), Scalar(-1)}) {
        texture.depth.at(2, 1) = wrong;
        texture.coverage.at(2, 1) = 0;
        EXPECT_FALSE(refusal(texture));
        texture.coverage.at(2, 1) = 1;
        ASSERT_TRUE(refusal(texture));
        EXPECT_NE(refusal(texture)->message.find("texel (2, 1)"), std::string::npos);
    }
    texture.depth.at(2, 1) = 2;
    EXPECT_FALSE(refusal(texture));
    texture.normal = Image<Vec3>(4, 2);
    EXPECT_TRUE(refusal(texture));
}

}  // namespace
}  // namespace relevo::relief
