// The ends of everything, for every resampler, the inverse, the box and the polygon in a scene: each is
// right, which a direct projection in space judges, or refused in one clear line.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pipeline/projection.hpp"
#include "pipeline/transform.hpp"
#include "raster/draw.hpp"
#include "relief/box.hpp"
#include "relief/draw_relief.hpp"
#include "relief/inverse_slices.hpp"
#include "relief/inverse_texels.hpp"
#include "relief/inverse_view.hpp"
#include "relief/prewarp.hpp"
#include "relief/relaxed_cone_map.hpp"
#include "relief/sprite.hpp"
#include "relief/surface_spheres.hpp"
#include "samples/scene/shapes/spheres.hpp"
#include "tests/support/drawing.hpp"

namespace relevo::relief {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr Scalar not_a_number = std::numeric_limits<Scalar>::quiet_NaN();

constexpr Resampler all_resamplers[] = {Resampler::Splat,       Resampler::OneDimensional,
                                        Resampler::Asymmetric,  Resampler::Compensated,
                                        Resampler::Interleaved, Resampler::Mesh};

void expect_one_line(const pipeline::Error& error) {
    EXPECT_GT(error.message.size(), 20u);
    EXPECT_EQ(error.message.find('\n'), std::string::npos) << error.message;
}

// A block of texels at one depth, coloured by their places; the rest is empty and holds nonsense.
struct Block {
    int width, height;   // of the texture
    int x0, y0, x1, y1;  // covered
};
constexpr Block blocks[] = {{8, 6, 0, 0, 8, 6}, {8, 6, 1, 2, 7, 5}, {9, 9, 4, 4, 5, 5}, {1, 9, 0, 0, 1, 9},
                            {9, 1, 0, 0, 9, 1}, {1, 1, 0, 0, 1, 1}, {5, 5, 0, 0, 0, 0}};

enum class Source { Orthographic, Skewed, Perspective };
ReliefCamera camera_of(const Block& block, Source source) {
    const SourceView view{{0, 0, -1}, {0, 1, 0}, block.width, block.height};
    const double extent = block.height * 0.25;
    if (source == Source::Perspective)
        return *perspective_camera(view, {0.1, -0.2, 3}, 3,
                                   {2 * std::atan(extent / 6) * 180 / 3.14159265358979});
    ReliefCamera camera = *orthographic_camera(view, {0, 0, 0}, extent);
    if (source == Source::Skewed) camera.b += 0.4 * camera.a;
    return camera;
}
ReliefTexture texture_of(const Block& block, const ReliefCamera& camera, double depth) {
    ReliefTexture texture = make_relief_texture(camera);
    const bool parallel = camera.projection == Projection::Orthographic;
    for (int y = 0; y < block.height; ++y)
        for (int x = 0; x < block.width; ++x) {
            const bool there = x >= block.x0 && x < block.x1 && y >= block.y0 && y < block.y1;
            texture.coverage.at(x, y) = there;
            texture.depth.at(x, y) =
                !there ? not_a_number : static_cast<Scalar>(parallel ? depth : 3 / (3 + depth));
            texture.color.at(x, y) = there ? LinearRgb{Scalar(x + 0.5), Scalar(y + 0.5), 1}
                                           : LinearRgb{not_a_number, not_a_number, not_a_number};
        }
    return texture;
}

// The depth that is left of it when it has been stored: a disparity keeps seven digits of 1.
double kept(const ReliefCamera& camera, double depth) {
    if (camera.projection == Projection::Orthographic) return double{static_cast<Scalar>(depth)};
    return 3 / double{static_cast<Scalar>(3 / (3 + depth))} - 3;
}

// What a line of sight from `eye` (or in a direction) through p meets at `depth` behind the plane, in texels.
glm::dvec2 seen_at(const ReliefCamera& camera, const Viewer& viewer, const glm::dvec3& p, double depth) {
    const glm::dvec3 f = forward(camera), t(viewer.place), way = viewer.place.w * p - t;
    const double to_plane = glm::dot(p - camera.corner, f);
    const glm::dvec3 x = p + way * ((depth - to_plane) / glm::dot(way, f));
    glm::dvec3 on_plane = x - depth * f;
    if (camera.projection == Projection::Perspective)
        on_plane = camera.eye +
                   (x - camera.eye) * (glm::dot(camera.corner - camera.eye, f) / glm::dot(x - camera.eye, f));
    const glm::dvec3 texels = glm::inverse(glm::dmat3(camera.a, camera.b, f)) * (on_plane - camera.corner);
    return {texels.x, texels.y};
}
// How far inside the block (u, v) lies; negative: outside.
double inside(const Block& b, const glm::dvec2& at) {
    return std::min(std::min(at.x - b.x0, b.x1 - at.x), std::min(at.y - b.y0, b.y1 - at.y));
}

struct Extreme {
    double h, e_u, e_v;
};
std::vector<Extreme> extremes() {
    std::vector<Extreme> all;
    for (const double h : {1e-6, 1.0, 1e9, inf})
        for (const double e_u : {-1e9, -200.0, 3.5, 4.0, 1e9})
            for (const double e_v : {3.5, 2.25, 1e9}) all.push_back({h, e_u, e_v});
    return all;
}
Viewer viewer_of(const ReliefCamera& camera, const Extreme& e) {
    if (e.h == inf)  // from a direction; an epipole at infinity has a slope of up to 4
        return viewer_toward(-forward(camera) + (e.e_u / 1e9) * camera.a + (e.e_v / 1e9) * camera.b);
    return viewer_at(plane_point(camera, e.e_u, e.e_v) - e.h * forward(camera));
}

// -------------------------------------------------------------------------------------------- resamplers
TEST(Extremes, EveryResamplerIsRightOrItsWindowIsRefused) {
    int refused = 0, drawn = 0, pixels = 0;
    for (const Block& block : blocks)
        for (const Source source : {Source::Orthographic, Source::Skewed, Source::Perspective})
            for (const Extreme& extreme : extremes())
                for (const double asked : {0.0, 1e-6, 0.5}) {
                    const ReliefCamera camera = camera_of(block, source);
                    const double depth = kept(camera, asked);
                    const Viewer viewer = viewer_of(camera, extreme);
                    const ReliefTexture texture = texture_of(block, camera, depth);
                    ASSERT_FALSE(refusal(texture));
                    const auto warp = make_warp(camera, viewer);
                    ASSERT_TRUE(warp);
                    const auto window = target_window(camera, *warp, depth_range(texture));
                    if (!window) {
                        expect_one_line(window.error());
                        ++refused;
                        continue;
                    }
                    if (window->width * window->height > 20'000) continue;  // for the sake of time
                    for (const Resampler resampler : all_resamplers)
                        for (const Jump jump : {Jump::Skin, Jump::Cut}) {
                            const Prewarped got =
                                prewarp(texture, *warp, *window,
                                        {.resampler = resampler, .jump = jump, .maps = true});
                            int wrong = 0;
                            for (int y = 0; y < window->height; ++y)
                                for (int x = 0; x < window->width; ++x) {
                                    const glm::dvec3 p =
                                        plane_point(camera, window->x0 + x + 0.5, window->y0 + y + 0.5);
                                    const glm::dvec2 at = seen_at(camera, viewer, p, depth),
                                                     beside = seen_at(camera, viewer, p + camera.a, depth);
                                    const double texel = std::abs(beside.x - at.x);  // of the source a pixel
                                    const double in = inside(block, at) / texel;     // in pixels
                                    const bool splat = resampler == Resampler::Splat;
                                    if (splat ? in > -1.5 : std::abs(in) < 0.02) continue;
                                    ++pixels;
                                    const bool there = got.coverage.at(x, y) != 0;
                                    if (there != (in > 0)) ++wrong;
                                    if (!there || in < 0) continue;
                                    const double u = std::clamp(at.x, block.x0 + 0.5, block.x1 - 0.5),
                                                 v = std::clamp(at.y, block.y0 + 0.5, block.y1 - 0.5);
                                    const LinearRgb& c = got.color.at(x, y);
                                    // the mesh is snapped to 1/256 pixel, and colours its border by texels
                                    const bool border = inside(block, at) < 0.52;
                                    const double near = resampler == Resampler::Mesh && border
                                                            ? 0.51 + 0.02 * texel
                                                            : 0.002 + 0.02 * texel;
                                    wrong += !(std::abs(double(c.r) - u) < near &&
                                               std::abs(double(c.g) - v) < near && c.b == 1);
                                    wrong +=
                                        !(std::abs(double(got.depth.at(x, y)) - depth) <= 2e-6 * (1 + depth));
                                }
                            ++drawn;
                            ASSERT_EQ(wrong, 0)
                                << "resampler " << int(resampler) << ", " << block.width << " x "
                                << block.height << ", source " << int(source) << ", h " << extreme.h << ", e "
                                << extreme.e_u << ' ' << extreme.e_v << ", depth " << depth;
                        }
                }
    std::printf("%d pictures, %d pixels judged, %d windows refused\n", drawn, pixels, refused);
    EXPECT_GT(drawn, 5000);
    EXPECT_GT(refused, 100);
}

TEST(Extremes, ALoneTexelOfSplatsIsOnePixelAtItsPlace) {
    const Block block{9, 9, 4, 4, 5, 5};
    const ReliefCamera camera = camera_of(block, Source::Orthographic);
    const ReliefTexture texture = texture_of(block, camera, 0.5);
    for (const Extreme& extreme : extremes()) {
        const Warp warp = *make_warp(camera, viewer_of(camera, extreme));
        const auto window = target_window(camera, warp, depth_range(texture));
        if (!window) continue;
        const Prewarped got = prewarp(texture, warp, *window, {.resampler = Resampler::Splat});
        const WarpedPoint to = warp_point(warp, 4.5, 4.5, Displacement{Scalar(0.5)});
        int covered = 0;
        for (const std::uint8_t c : got.coverage.pixels()) covered += c;
        ASSERT_EQ(covered, 1);
        // a place within float's rounding of a border may fall to either side
        const double u = to.u - window->x0, v = to.v - window->y0;
        const int x = static_cast<int>(u), y = static_cast<int>(v);
        if (std::abs(u - std::round(u)) < 1e-3 || std::abs(v - std::round(v)) < 1e-3) continue;
        EXPECT_TRUE(got.coverage.at(x, y));
    }
}

// A depth that is not a number is refused by name; who warps it all the same loses that texel only.
TEST(Extremes, ANotANumberSpoilsNothingElse) {
    const Block block{9, 9, 0, 0, 9, 9};
    const ReliefCamera camera = camera_of(block, Source::Orthographic);
    const ReliefTexture whole = texture_of(block, camera, 0.5);
    ReliefTexture texture = whole;
    texture.depth.at(4, 4) = not_a_number;
    ASSERT_TRUE(refusal(texture));
    expect_one_line(*refusal(texture));
    EXPECT_NE(refusal(texture)->message.find("(4, 4)"), std::string::npos);
    const Warp warp = *make_warp(camera, viewer_at({1, 0.5, 3}));
    const Window window = *target_window(camera, warp, depth_range(whole));
    for (const Resampler resampler : all_resamplers) {
        const Prewarped right = prewarp(whole, warp, window, {.resampler = resampler}),
                        got = prewarp(texture, warp, window, {.resampler = resampler});
        int checked = 0;
        for (int y = 0; y < window.height; ++y)
            for (int x = 0; x < window.width; ++x) {
                const glm::dvec2 at =
                    unwarp_point(warp, window.x0 + x + 0.5, window.y0 + y + 0.5, Displacement{Scalar(0.5)});
                if (std::max(std::abs(at.x - 4.5), std::abs(at.y - 4.5)) < 1.5) continue;
                if (std::isnan(double(got.depth.at(x, y))) || !right.coverage.at(x, y)) continue;
                ++checked;
                EXPECT_TRUE(got.coverage.at(x, y));
                EXPECT_EQ(got.color.at(x, y), right.color.at(x, y)) << int(resampler) << ' ' << x << ' ' << y;
            }
        EXPECT_GT(checked, 30) << int(resampler);
    }
}

// ------------------------------------------------------------------------------------------------ inverse
TEST(Extremes, EveryInverseIsRightOrRefused) {
    int views = 0, hits = 0;
    for (const Block& block : blocks)
        for (const Source source : {Source::Orthographic, Source::Skewed, Source::Perspective})
            for (const Extreme& extreme : extremes())
                for (const double depth : {0.0, 0.5}) {
                    if (extreme.h == inf) continue;  // a screen has an eye
                    const ReliefCamera camera = camera_of(block, source);
                    const ReliefTexture texture = texture_of(block, camera, depth);
                    const Viewer viewer = viewer_of(camera, extreme);
                    const glm::dvec3 eye(viewer.place),
                        middle = plane_point(camera, block.width / 2.0, block.height / 2.0) +
                                 depth * forward(camera),
                        toward = middle - eye;
                    const double distance = std::sqrt(glm::dot(toward, toward)),
                                 angle = 2.4 * std::atan(1.5 / distance) * 180 / 3.14159265358979;
                    const auto screen = perspective_camera({toward, {0.3, 1, 0.2}, 12, 12}, eye, distance,
                                                           {std::min(angle, 90.0)});
                    ASSERT_TRUE(screen);
                    // A line of sight from so far away and so near to the plane is not known better than
                    // this.
                    const double e = std::max(std::abs(extreme.e_u), std::abs(extreme.e_v)),
                                 blur = 1e-3 + 1e-15 * e * e / (extreme.h + depth);
                    const ReliefSolid solid = extruded_solid(texture);
                    const ConeStepMap cones = make_cone_step_map(solid),
                                      relaxed = make_relaxed_cone_map(solid);
                    const auto check = [&](const char* how, auto&& find) {
                        const auto view = inverse_view(texture, solid, *screen, find);
                        ASSERT_TRUE(view) << how;
                        ++views;
                        for (int y = 0; y < 12; ++y)
                            for (int x = 0; x < 12; ++x) {
                                const glm::dvec3 p = plane_point(*screen, x + 0.5, y + 0.5);
                                const double down = glm::dot(p - eye, forward(camera));
                                const bool there = view->coverage.at(x, y) != 0;
                                if (down <= 0) {  // the line of sight leads away from the plane
                                    ASSERT_FALSE(there) << how;
                                    continue;
                                }
                                ASSERT_TRUE(std::isfinite(view->depth.at(x, y))) << how;
                                const glm::dvec2 at = seen_at(camera, viewer, p, depth);
                                const double in = inside(block, at);
                                // through the sides of the pillars behind the block's border one sees it, too
                                if (in < blur) continue;
                                ++hits;
                                ASSERT_TRUE(there)
                                    << how << ' ' << x << ' ' << y << ", h " << extreme.h << ", e "
                                    << extreme.e_u << ' ' << extreme.e_v << " in " << in;
                                const int i = static_cast<int>(at.x), j = static_cast<int>(at.y);
                                if (std::abs(at.x - std::round(at.x)) < blur ||
                                    std::abs(at.y - std::round(at.y)) < blur)
                                    continue;
                                ASSERT_EQ(view->color.at(x, y), texture.color.at(i, j)) << how;
                            }
                    };
                    check("slices", [&](const ReliefRay& r) { return find_by_slices(solid, r, {16, 8}); });
                    check("texels", [&](const ReliefRay& r) { return find_by_texels(solid, r); });
                    check("cones", [&](const ReliefRay& r) { return find_by_cones(solid, cones, r); });
                    check("relaxed cones",
                          [&](const ReliefRay& r) { return find_by_relaxed_cones(solid, relaxed, r, 8); });
                    if (HasFatalFailure()) return;
                }
    std::printf("%d views, %d lines of sight judged\n", views, hits);
    EXPECT_GT(hits, 50'000);
}

TEST(Extremes, AViewerOnOrBehindThePlaneIsRefusedByAll) {
    const Block block{8, 6, 0, 0, 8, 6};
    const ReliefCamera camera = camera_of(block, Source::Orthographic);
    const ReliefTexture texture = texture_of(block, camera, 0.5);
    for (const glm::dvec3& eye :
         {glm::dvec3(0.3, 0.1, 0), glm::dvec3(0.3, 0.1, -1e-9), glm::dvec3(0, 0, -5)}) {
        const ReliefCamera screen = *perspective_camera({{0.1, 0.2, 1}, {0, 1, 0}, 8, 8}, eye, 1, {60});
        const auto warp = make_warp(camera, viewer_at(eye));
        const auto rays = relief_rays(camera, screen);
        const auto sprite = draw_sprite(texture, screen);
        const ReliefSolid solid = extruded_solid(texture);
        const auto inverse = inverse_view(texture, solid, screen, [&](const ReliefRay& r) {
            return find_by_slices(solid, r, {16, 8});
        });
        ASSERT_TRUE(!warp && !rays && !sprite && !inverse) << eye.z;
        for (const pipeline::Error& error : {warp.error(), rays.error(), sprite.error(), inverse.error()}) {
            expect_one_line(error);
            EXPECT_NE(error.message.find("in front"), std::string::npos);
        }
    }
}

TEST(Extremes, TheInverseOfANotANumberIsAHole) {
    const Block block{9, 9, 0, 0, 9, 9};
    const ReliefCamera camera = camera_of(block, Source::Orthographic);
    ReliefTexture texture = texture_of(block, camera, 0.5);
    texture.depth.at(4, 4) = not_a_number;
    const ReliefSolid solid = extruded_solid(texture);
    for (int x = 0; x < 9; ++x) {
        const ReliefRay straight{{x + 0.5, 4.5}, {0, 0}};
        EXPECT_EQ(find_by_slices(solid, straight, {16, 8}).has_value(), x != 4);
        EXPECT_EQ(find_by_texels(solid, straight).has_value(), x != 4);
    }
}

// ---------------------------------------------------------------------------------------------------- box
const Box unit_box{{-1, -1, -1}, {1, 1, 1}};

TEST(Extremes, ABoxFromFarAwayIsAParallelView) {
    const BoxRelief box = *capture_box(RayCapture{scene::sphere_object}, unit_box, 32);
    for (const double distance : {1e3, 1e6, 1e9}) {
        const glm::dvec3 eye(0, 0, distance);
        const double angle = 2 * std::atan(1.25 / distance) * 180 / 3.14159265358979;
        const ReliefCamera screen = *perspective_camera({-eye, {0, 1, 0}, 40, 40}, eye, distance, {angle});
        const ViewImage view = draw_box(box, screen);
        int wrong = 0;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x) {
                const double r = std::sqrt((x - 19.5) * (x - 19.5) + (y - 19.5) * (y - 19.5)) / 16;
                if (std::abs(r - 1) < 0.08) continue;
                wrong += (view.coverage.at(x, y) != 0) != (r < 1);
            }
        EXPECT_EQ(wrong, 0) << distance;
    }
}

TEST(Extremes, ABoxFromItsPlanesEdgesAndInside) {
    const BoxRelief box = *capture_box(RayCapture{scene::complex_object}, unit_box, 24);
    for (const double distance : {1e-6, 1e-3, 0.5})
        for (int i = 0; i < 27; ++i) {
            // on faces, edges and corners, within `distance` of them outside, and in the middle
            const glm::dvec3 side(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1), eye = (1 + distance) * side;
            const glm::dvec3 toward = i == 13 ? glm::dvec3(0.3, 0.2, 1) : -side;
            const ReliefCamera screen = *perspective_camera({toward, {0.2, 1, 0.3}, 24, 24}, eye, 1, {60});
            EXPECT_EQ(box_region(unit_box, eye).number(), i);
            for (const Composite composite : {Composite::Depth, Composite::FaceOrder}) {
                const ViewImage view = draw_box(box, screen, {0.1, composite});
                int covered = 0;
                for (std::size_t k = 0; k < view.coverage.pixels().size(); ++k) {
                    const int label = view.coverage.pixels()[k];
                    ASSERT_LE(label, 6);
                    if (!label) continue;
                    ++covered;
                    ASSERT_TRUE(std::isfinite(view.depth.pixels()[k]) && view.depth.pixels()[k] > 0);
                    const LinearRgb& c = view.color.pixels()[k];
                    ASSERT_TRUE(c.r >= 0 && c.r <= 1 && c.g >= 0 && c.g <= 1 && c.b >= 0 && c.b <= 1);
                }
                if (i == 13)  // inside, no face is in front
                    EXPECT_EQ(covered == 0, composite == Composite::FaceOrder);
                else
                    EXPECT_GT(covered, 20) << i << ' ' << distance;
            }
        }
    // exactly on a face's plane the face is not in front
    EXPECT_EQ(box_region(unit_box, {0, 0, 1}).faces(), 0);
}

TEST(Extremes, ABoxOfOneTexelAFaceAndOfNothing) {
    const Spheres nothing{};
    const BoxRelief one = *capture_box(RayCapture{scene::sphere_object}, unit_box, 1),
                    none = *capture_box(RayCapture{nothing}, unit_box, 8);
    const ReliefCamera screen = *perspective_camera({{0, 0, -1}, {0, 1, 0}, 24, 24}, {0, 0, 4}, 1, {50});
    const ViewImage of_one = draw_box(one, screen), of_none = draw_box(none, screen);
    int covered = 0;
    for (const std::uint8_t c : of_one.coverage.pixels()) {
        covered += c != 0;
        EXPECT_TRUE(c == 0 || c == 1 + int(Face::Front));
    }
    // a square of side 2, 3 before the eye
    const double side = 2 / 3.0 / (2 * std::tan(25 * 3.14159265 / 180)) * 24;
    EXPECT_NEAR(covered, side * side, 2 * side);
    for (const std::uint8_t c : of_none.coverage.pixels()) EXPECT_EQ(c, 0);
    const auto refused = capture_box(RayCapture{scene::sphere_object}, unit_box, 0);
    ASSERT_FALSE(refused);
    expect_one_line(refused.error());
}

// -------------------------------------------------------------------------------------------- draw_relief
struct Stage {
    ReliefCamera source;
    Prewarped picture;
    Viewer viewer;
    raster::Scene scene;
};
// The block, warped for a viewer at `eye`, in front of an eye that looks at its middle.
Stage stage(const Block& block, const glm::dvec3& eye, double depth) {
    Stage s;
    s.source = camera_of(block, Source::Orthographic);
    s.viewer = viewer_at(eye);
    const ReliefTexture texture = texture_of(block, s.source, depth);
    const Warp warp = *make_warp(s.source, s.viewer);
    s.picture = prewarp(texture, warp, *target_window(s.source, warp, depth_range(texture)));
    s.scene.camera.eye_from_world = *pipeline::look_at(eye, {0, 0, 0}, {0, 1, 0});
    s.scene.camera.clip_from_eye = *pipeline::perspective({50}, 1, 1e-4, inf, pipeline::DepthRange::Reversed);
    s.scene.background = {0, 0, 0};
    return s;
}
raster::Frame drawn(const Stage& s) {
    raster::Frame frame = tests::frame_of(32, 32, true);
    raster::draw(s.scene, tests::unlit(), frame);
    draw_relief({&s.picture, s.source, s.viewer, {}, Reading::Nearest, Scalar(0.1)}, s.scene, tests::unlit(),
                frame);
    return frame;
}
int covered_in(const raster::Frame& frame) {
    int covered = 0;
    for (const Scalar z : frame.depth.pixels()) covered += z > 0;
    return covered;
}

TEST(Extremes, SmallAndEmptyPicturesInAScene) {
    for (const Block& block : blocks) {
        const glm::dvec3 eye(0.4, 0.3, 3);
        const Stage s = stage(block, eye, 0.25);
        const raster::Frame frame = drawn(s);
        const ReliefCamera screen = *perspective_camera({-eye, {0, 1, 0}, 32, 32}, eye, 1, {50});
        int wrong = 0;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const glm::dvec2 at =
                    seen_at(s.source, s.viewer, plane_point(screen, x + 0.5, y + 0.5), 0.25);
                const double in = inside(block, at);
                const bool there = frame.depth.at(x, y) > 0;
                if (std::abs(in) < 1) continue;  // the picture's own pixels are as large as texels
                wrong += there != (in > 0);
            }
        EXPECT_EQ(wrong, 0) << block.width << " x " << block.height;
        if (block.x1 == 0) {
            EXPECT_EQ(covered_in(frame), 0);
        } else {
            EXPECT_GT(covered_in(frame), 0);
        }
    }
}

TEST(Extremes, APictureSeenFromElsewhereOrWithNonsenseDepthDrawsNoFault) {
    const Block block{8, 6, 0, 0, 8, 6};
    Stage s = stage(block, {0.4, 0.3, 3}, 0.25);
    const int usual = covered_in(drawn(s));
    EXPECT_GT(usual, 100);
    // a viewer on the plane or behind it, or nowhere: another picture, or none, but finite
    for (const Viewer& viewer : {viewer_at({0, 0, 0}), viewer_at({0, 0, -2}), viewer_at({1e30, 0, 1}),
                                 viewer_toward({0, 0, 1}), viewer_toward({1, 0, 0}), Viewer{{0, 0, 0, 0}}}) {
        Stage other = s;
        other.viewer = viewer;
        const raster::Frame frame = drawn(other);
        for (const Scalar z : frame.depth.pixels()) ASSERT_TRUE(z >= 0 && z <= 1);
    }
    // one depth that is not a number, or endless, or before the eye: that pixel of the picture is not drawn
    const auto with_depth = [&](Scalar depth) {
        Stage other = s;
        const Window& w = other.picture.window;
        other.picture.depth.at(4 - w.x0, 3 - w.y0) = depth;
        return drawn(other);
    };
    const raster::Frame right = drawn(s);
    for (const Scalar depth : {not_a_number, std::numeric_limits<Scalar>::infinity(), Scalar(-100)}) {
        const raster::Frame frame = with_depth(depth);
        const int lost = usual - covered_in(frame);
        EXPECT_GT(lost, 0) << depth;
        EXPECT_LT(lost, usual / 10) << depth;
        for (std::size_t i = 0; i < right.depth.pixels().size(); ++i)
            if (const Scalar z = frame.depth.pixels()[i]; z > 0) {
                ASSERT_EQ(z, right.depth.pixels()[i]);
            }
    }
}

}  // namespace
}  // namespace relevo::relief
