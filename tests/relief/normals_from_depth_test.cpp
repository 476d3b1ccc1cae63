#include "relief/normals_from_depth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "relief/ray_cast.hpp"
#include "relief/surface_checker_cube.hpp"
#include "relief/surface_plane_step.hpp"
#include "samples/scene/shapes/spheres.hpp"

namespace relevo::relief {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double degrees_between(const Vec3& a, const Vec3& b) {
    const double cosine = glm::dot(glm::dvec3(a), glm::dvec3(b));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / pipeline::pi;
}

ReliefCamera front(int size) {
    return *orthographic_camera({{0, 0, -1}, {0, 1, 0}, size, size}, {0, 0, 1}, 2);
}

struct Angles {
    double inside = 0, border = 0;  // mean error, degrees
    int inside_texels = 0, border_texels = 0;
};
// Inside: the texel and its neighbours, two away, are covered, and its normal is less than 60 degrees from
// the line of sight.
Angles angles(const ReliefTexture& texture, double jump) {
    const Image<Vec3> estimated = normals_from_depth(texture, jump);
    Angles result;
    for (int y = 0; y < texture.camera.height; ++y)
        for (int x = 0; x < texture.camera.width; ++x) {
            if (!texture.coverage.at(x, y)) continue;
            const SourceRay ray = source_ray(texture.camera, x + 0.5, y + 0.5);
            bool inside = glm::dot(glm::dvec3(texture.normal.at(x, y)), glm::normalize(ray.direction)) < -0.5;
            for (const int k : {-2, 2})
                inside = inside && texture.coverage.holds(x + k, y) && texture.coverage.at(x + k, y) &&
                         texture.coverage.holds(x, y + k) && texture.coverage.at(x, y + k);
            const double off = degrees_between(estimated.at(x, y), texture.normal.at(x, y));
            (inside ? result.inside : result.border) += off;
            ++(inside ? result.inside_texels : result.border_texels);
        }
    result.inside /= result.inside_texels, result.border /= result.border_texels;
    return result;
}

TEST(NormalsFromDepth, AreCloseToTheTrueOnes) {
    struct Row {
        const char* name;
        const Spheres* object;
        double most_inside, most_border;
    };
    for (const auto& [name, object, most_inside, most_border] :
         {Row{"sphere", &scene::sphere_object, 0.007, 0.5}, Row{"bumpy", &scene::bumpy_object, 1.9, 3.6},
          Row{"complex", &scene::complex_object, 0.8, 4.8}}) {
        const Angles a = angles(ray_cast(*object, front(256)), 0.1);
        std::printf("%s: inside %.3f degrees (%d texels), at borders %.2f (%d)\n", name, a.inside,
                    a.inside_texels, a.border, a.border_texels);
        EXPECT_GT(a.inside_texels, 10000);
        EXPECT_LT(a.inside, most_inside);
        EXPECT_LT(a.border, most_border);
    }
}

TEST(NormalsFromDepth, AreAsGoodFromAPerspectiveSource) {
    const ReliefCamera camera =
        *perspective_camera({{-1, -1, -2}, {0, 1, 0}, 256, 256}, {1.6, 1.6, 3.2}, 2.2, {35});
    EXPECT_LT(angles(ray_cast(scene::sphere_object, camera), 0.1).inside, 0.01);
}

TEST(NormalsFromDepth, ThePlaneIsExactUpToItsStep) {
    const ReliefTexture texture =
        ray_cast(PlaneStep{0.5}, *orthographic_camera({{0, 0, -1}, {0, 1, 0}, 40, 40}, {0, 0, 0.5}, 2));
    const Image<Vec3> cut = normals_from_depth(texture, 0.1), skin = normals_from_depth(texture, infinity);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            EXPECT_LT(glm::length(cut.at(x, y) - Vec3(0, 0, 1)), 1e-6);
            const bool at_step = x == 21 || x == 22;  // the edge x = 0.1 is texel column 22
            EXPECT_EQ(skin.at(x, y).x < Scalar(-0.9), at_step) << x;
        }
}

TEST(NormalsFromDepth, ALoneTexelFacesTheViewerAndEmptyOnesHaveNone) {
    ReliefTexture texture = make_relief_texture(front(5));
    texture.coverage.at(2, 3) = 1;
    const Image<Vec3> normal = normals_from_depth(texture, 0.1);
    EXPECT_EQ(normal.at(2, 3), Vec3(0, 0, 1));
    EXPECT_EQ(normal.at(1, 1), Vec3(0, 0, 0));
    texture.coverage.at(3, 3) = 1, texture.depth.at(3, 3) = Scalar(0.4);  // one texel is 0.4 wide
    EXPECT_LT(glm::length(normals_from_depth(texture, 1).at(2, 3) - Vec3(std::sqrt(0.5), 0, std::sqrt(0.5))),
              1e-6);
}

}  // namespace
}  // namespace relevo::relief
