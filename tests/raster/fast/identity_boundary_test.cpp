// The fast path at its seams: boxes at the sizes where a stage changes its way, tiles, groups of lanes, equal
// depths, the guard band. Corners stand on chosen 1/256 of a pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "pipeline/elementary.hpp"
#include "tests/raster/fast/identity_window.hpp"

namespace relevo::tests::identity {
namespace {

using pipeline::Scalar;
using raster::Settings;

constexpr double pixel = 256;

// Each test calls it as often as it has scenes, so that few ways a scene are all ways a test.
testing::AssertionResult is_same(WindowScene& scene, std::vector<Way> ways, const Settings& settings) {
    std::string found = first_difference(scene.scene(), settings, scene.size(), ways);
    if (!found.empty()) return testing::AssertionFailure() << found;
    // Untextured triangles are painted when nothing but colour and depth is asked for.
    static unsigned turn = 0;
    ++turn;
    WindowScene bare = scene;
    bare.without_textures();
    Settings painted = settings;
    painted.shading = turn % 3 ? raster::Shading::Gouraud : raster::Shading::Flat;
    painted.output = turn % 2 ? raster::Output::Raw : raster::Output::Srgb;
    for (Way& way : ways) way.linear = way.visible = false;
    found = first_difference(bare.scene(), painted, bare.size(), ways);
    if (found.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "painted: " << found;
}
testing::AssertionResult is_same_few(WindowScene& scene, const Settings& settings = textured_phong()) {
    static std::size_t number = 0;
    return is_same(scene, few_ways(number++), settings);
}
testing::AssertionResult is_same_all(WindowScene& scene, const Settings& settings = textured_phong()) {
    return is_same(scene, all_ways(), settings);
}

Settings gouraud() {
    Settings settings = textured_phong();
    settings.shading = raster::Shading::Gouraud;
    return settings;
}

TEST(Boundary, CornersStandWhereTheyAreAsked) {
    for (const Size size : {Size{64, 32}, Size{301, 289}, Size{1000, 7}})
        for (const View view : {View::Parallel, View::Perspective}) {
            WindowScene scene(size, view);
            const double beyond = std::min(size.width, size.height);  // within the guard band
            std::vector<Corners> asked;
            for (int i = 0; i < 200; ++i) {
                asked.push_back({scene.anywhere(beyond), scene.anywhere(beyond), scene.anywhere(beyond)});
                scene.add(asked.back());
            }
            Watch watch(size.width, size.height);
            watch.on_snapped = [&](const raster::TriangleSnapped& e) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const Corner& c = asked[e.primitive][k];
                    EXPECT_EQ(e.corners[k].x, c.x);
                    EXPECT_EQ(e.corners[k].y, c.y);
                    EXPECT_EQ(e.corners[k].z, view == View::Parallel ? c.depth : Scalar(0.5 / c.w));
                }
            };
            raster::Frame frame = frame_of(size.width, size.height);
            draw_watched(scene.scene(), textured_phong(), frame, watch);
            EXPECT_GT(watch.snapped, 190);
            EXPECT_EQ(watch.clipped, 0);
        }
}

// ------------------------------------------------------------------------------------------- sizes of boxes
// A triangle with a box of this size (1/256 px) and its upper left corner here: one of the halves of the box,
// a needle along its diagonal, or one with a corner somewhere on a side.
Corners in_box(WindowScene& scene, double x, double y, double width, double height) {
    hard::Random& random = scene.random();
    const double right = x + width, below = y + height;
    Corner c[4] = {{x, y}, {right, y}, {right, below}, {x, below}};
    const Scalar depths[] = {Scalar(0.25), Scalar(0.5), Scalar(random.unit())};  // often equal
    for (Corner& corner : c) {
        corner.depth = depths[random.integer(0, 2)];
        corner.w = pipeline::exp2(static_cast<double>(random.integer(-1, 3)));
    }
    const auto k = static_cast<std::size_t>(random.integer(0, 3));
    const auto next = [&](std::size_t by) { return c[(k + by) % 4]; };
    Corner third = next(1);
    switch (random.integer(0, 2)) {
        case 0:
            break;
        case 1:
            third.x = next(0).x, third.y = next(0).y;
            (k % 2 ? third.x : third.y) += random.coin() ? 1 : -1;
            third.x = std::clamp(third.x, x, right), third.y = std::clamp(third.y, y, below);
            break;
        default:
            third.x = x + std::floor(width * random.unit()), third.y = y + std::floor(height * random.unit());
    }
    Corners t{next(0), third, next(2)};
    if (random.coin()) std::swap(t[0], t[1]);
    return t;
}

TEST(Boundary, BoxesOfEveryExtent) {
    constexpr int extents[] = {0,  1,   2,   3,   4,   5,   7,   8,   9,   11,  12,  13,  14,  15,  16,  17,
                               18, 24,  25,  31,  32,  33,  47,  48,  49,  63,  64,  65,  66,  80,  95,  96,
                               97, 104, 108, 109, 110, 111, 112, 113, 127, 128, 129, 192, 193, 255, 256, 257};
    constexpr double offsets[] = {0, 1, 127, 128, 129, 255};
    const Size size{301, 289};
    for (const int extent : extents)
        for (const int more : {-1, 0, 1})
            for (const View view : {View::Parallel, View::Perspective}) {
                const double length = std::max(extent * pixel + more, 0.0);
                WindowScene scene(size, view, std::uint64_t(extent * 3 + more + 1));
                hard::Random& random = scene.random();
                for (int i = 0; i < 40; ++i) {
                    const auto place = [&](int pixels, double l) {
                        const double tile = 32 * pixel * double(random.integer(0, pixels / 32));
                        const double back = random.coin() ? std::floor(l * random.unit() / pixel) * pixel : 0;
                        return tile - back + offsets[random.integer(0, 5)];
                    };
                    const double other =
                        random.coin() ? length : double(extents[random.integer(0, 47)]) * pixel;
                    const double width = i % 2 ? length : other, height = i % 2 ? other : length;
                    scene.add(
                        in_box(scene, place(size.width, width), place(size.height, height), width, height));
                }
                ASSERT_TRUE(is_same_few(scene, extent % 2 ? textured_phong() : gouraud()))
                    << "extent " << extent << " px " << more;
            }
}

TEST(Boundary, SmallBoxesOfEveryShape) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        WindowScene scene({301, 289}, seed % 2 ? View::Perspective : View::Parallel, seed);
        hard::Random& random = scene.random();
        for (int width = 0; width <= 17; ++width)
            for (int height = 0; height <= 17; ++height) {
                const auto length = [&](int pixels) {
                    return std::max(pixels * pixel + double(random.integer(-2, 2)), 0.0);
                };
                const Corner at = scene.anywhere(4);
                scene.add(in_box(scene, at.x, at.y, length(width), length(height)));
            }
        ASSERT_TRUE(is_same_few(scene)) << seed;
    }
}

// ------------------------------------------------------------------------------------------------- tiles
TEST(Boundary, EdgesAndCornersOfTiles) {
    const Size size{289, 301};
    for (const int tile : {32, 64, 128})
        for (const double off : {-129.0, -128.0, -127.0, -1.0, 0.0, 1.0, 127.0, 128.0, 129.0}) {
            WindowScene scene(size, off == 0 ? View::Parallel : View::Perspective, std::uint64_t(tile));
            const double t = tile * pixel;
            for (double y = 0; y < size.height * pixel; y += t)
                for (double x = 0; x < size.width * pixel; x += t) {
                    const double left = x + off, top = y + off;
                    const auto c = [&](double cx, double cy) { return Corner{cx, cy, Scalar(0.5), 1}; };
                    if (scene.random().coin()) {  // the tile, in two halves
                        scene.add({c(left, top), c(left + t, top), c(left, top + t)});
                        scene.add({c(left + t, top), c(left + t, top + t), c(left, top + t)});
                    } else {  // round its corner, across four of them, and an edge along its side
                        scene.add(
                            {c(left - 300, top - 200), c(left + 256, top - 100), c(left - 17, top + 280)});
                        scene.add({c(left, top), c(left + t, top), c(left + t / 2, top - 5 * pixel)});
                        scene.add({c(left, top), c(left, top + t), c(left - 5 * pixel, top + t / 2)});
                    }
                }
            ASSERT_TRUE(is_same_few(scene)) << "tile " << tile << ", off by " << off;
        }
}

TEST(Boundary, TrianglesThatCoverTheWholePicture) {
    for (const Size size : {Size{1, 1}, Size{63, 65}, Size{301, 289}, Size{128, 128}})
        for (const View view : {View::Parallel, View::Perspective}) {
            WindowScene scene(size, view);
            for (int i = 0; i < 20; ++i) {
                const double w = size.width * pixel, h = size.height * pixel;
                const auto d = [&] { return Scalar(scene.random().integer(1, 8)) / 8; };
                const auto over = [&] { return std::floor(scene.random().between(0, 500)); };
                Corners t{Corner{-over(), -over(), d(), 1}, Corner{2 * w + over(), -over(), d(), 2},
                          Corner{-over(), 2 * h + over(), d(), 4}};
                scene.add(t);
                if (i % 5 == 4) scene.next_model();
            }
            ASSERT_TRUE(is_same_all(scene)) << size.width;
            ASSERT_TRUE(is_same_all(scene, gouraud())) << size.width;
        }
}

// -------------------------------------------------------------------------------------- numbers of triangles
TEST(Boundary, GroupsThatAreNotFull) {
    for (int triangles = 0; triangles <= 70; ++triangles) {
        WindowScene scene({70, 67}, triangles % 2 ? View::Perspective : View::Parallel,
                          std::uint64_t(triangles));
        for (int i = 0; i < triangles % 23; ++i) scene.add_vertex(scene.anywhere());  // nobody uses them
        for (int i = 0; i < triangles; ++i) {
            if (triangles % 3 == 0 && i % 7 == 3) scene.next_model();
            scene.add({scene.anywhere(5), scene.anywhere(5), scene.anywhere(5)});
        }
        for (int i = 0; i < triangles % 5; ++i) scene.add_vertex(scene.anywhere());
        ASSERT_TRUE(is_same_few(scene)) << triangles << " triangles";
    }
}

TEST(Boundary, NothingToDraw) {
    WindowScene empty({65, 33}, View::Parallel);
    EXPECT_TRUE(is_same_all(empty));
    WindowScene unused({65, 33}, View::Parallel);
    for (int i = 0; i < 20; ++i) unused.add_vertex(unused.anywhere());
    unused.next_model(), unused.next_model();
    unused.add({Corner{0, 0}, {5000, 0}, {0, 5000}});
    unused.next_model();
    EXPECT_TRUE(is_same_all(unused));
    const raster::Scene no_models{{}, {}, {}, {1, 0, 1}};
    EXPECT_EQ(first_difference(no_models, textured_phong(), {65, 33}, all_ways()), "");
}

TEST(Boundary, OneClippedTriangleInAGroup) {
    for (const View view : {View::Parallel, View::Perspective})
        for (int clipped = 0; clipped < 40; ++clipped) {
            WindowScene scene({90, 75}, view, std::uint64_t(clipped));
            for (int i = 0; i < 40; ++i) {
                Corners t{scene.anywhere(), scene.anywhere(), scene.anywhere()};
                if (i == clipped) {  // beyond the guard band, the near plane, or the eye
                    if (clipped % 2)
                        t[1].x = 90 * pixel * 8;
                    else if (view == View::Parallel)
                        t[1].depth = Scalar(1.5);
                    else
                        t[1].w = clipped % 4 ? 0.25 : -1;
                }
                scene.add(t);
            }
            ASSERT_TRUE(is_same_few(scene)) << clipped;
        }
}

TEST(Boundary, AFanOfTenThousand) {
    for (const View view : {View::Parallel, View::Perspective}) {
        WindowScene scene({201, 199}, view);
        const double x = 100 * pixel + 77, y = 99 * pixel + 128;
        const std::uint32_t middle = scene.add_vertex({x, y, Scalar(0.5), 2});
        constexpr int count = 10000;
        for (int i = 0; i <= count; ++i) {
            const pipeline::Degrees angle{360.0 * i / count};
            scene.add_vertex({std::nearbyint(x + 90 * pixel * pipeline::cos(angle)),
                              std::nearbyint(y + 90 * pixel * pipeline::sin(angle)), Scalar(0.5),
                              i % 2 ? 1.0 : 4.0});
        }
        for (std::uint32_t i = 0; i < count; ++i) scene.add_triangle(middle, middle + 1 + i, middle + 2 + i);
        EXPECT_TRUE(is_same_all(scene));
    }
}

// Edge values up to 2^31 and more: 128 x 256 pixels have an area of 2^31, in 1/256 pixel. Small triangles and
// large ones meet along upright edges and along diagonals, both ways round, at all places within a block.
TEST(Boundary, AreasAtTheRangeOfInt32) {
    const Size size{607, 277};
    for (const View view : {View::Parallel, View::Perspective})
        for (const int more : {-1, 0, 1, 3 * 256 + 1, 100 * 256}) {
            WindowScene scene(size, view);
            const double top = 7 * pixel + 128, bottom = top + 256 * pixel;
            const auto corner = [&](double x, double y) {
                const int k = static_cast<int>(x / pixel + y / 7) % 5;
                return Corner{x, y, Scalar(0.25) + Scalar(0.125) * Scalar(k), 1.0 + k};
            };
            double left = 5 * pixel + 77;
            for (const int width : {128 * 256, 128 * 256 + more, 128 * 256 - more, 5 * 256 + 3, 180 * 256}) {
                const double right = left + width;
                scene.add({corner(left, top), corner(right, top), corner(left, bottom)});
                scene.add({corner(right, top), corner(right, bottom), corner(left, bottom)});
                left = right;
            }
            ASSERT_TRUE(is_same_few(scene)) << more;
            ASSERT_TRUE(is_same_few(scene, gouraud())) << more;
        }
}

TEST(Boundary, AHundredModelsInOneTile) {
    for (const View view : {View::Parallel, View::Perspective})
        for (const raster::Shading shading : {raster::Shading::Unlit, raster::Shading::Flat,
                                              raster::Shading::Gouraud, raster::Shading::Phong}) {
            WindowScene scene({64, 60}, view, 3);
            for (int model = 0; model < 100; ++model) {
                for (int i = 0; i < 6; ++i) scene.add({scene.anywhere(), scene.anywhere(), scene.anywhere()});
                scene.next_model();
            }
            Settings settings = textured_phong();
            settings.shading = shading;
            EXPECT_TRUE(is_same_all(scene, settings)) << int(shading);
        }
}

// Light between corners is clamped where one of them is beyond what a picture shows, and only there.
TEST(Boundary, LightBeyondThePicturesRange) {
    constexpr Scalar inf = std::numeric_limits<Scalar>::infinity(),
                     nan = std::numeric_limits<Scalar>::quiet_NaN();
    for (const View view : {View::Parallel, View::Perspective})
        for (const pipeline::LinearRgb color : {pipeline::LinearRgb{Scalar(-0.5), Scalar(0.5), 1},
                                                {Scalar(0.5), Scalar(-0.25), 2},
                                                {1, 40, Scalar(-1e-3)},
                                                {Scalar(-1e30), Scalar(1e30), 0},
                                                {inf, -inf, nan}}) {
            WindowScene scene({130, 67}, view);
            for (int i = 0; i < 12; ++i) {
                scene.material().color = color;
                scene.add({scene.anywhere(5), scene.anywhere(5), scene.anywhere(5)});
                if (i % 4 == 3) scene.next_model();
            }
            for (int turn = 0; turn < 6; ++turn) ASSERT_TRUE(is_same_few(scene, gouraud())) << color.g;
        }
}

// Medium triangles, then tiny ones, and so on: a tile that is painted goes over to fragments and to blocks.
TEST(Boundary, RunsOfMediumAndTinyTriangles) {
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        hard::Random random(seed);
        const auto side = [&] { return static_cast<int>(random.integer(30, 140)); };
        const int width = side(), height = side();
        WindowScene scene({width, height}, seed % 2 ? View::Perspective : View::Parallel, seed);
        const bool in_planes = random.coin();
        for (int run = 0, runs = static_cast<int>(random.integer(2, 5)); run < runs; ++run) {
            if (random.integer(0, 3) == 0) scene.next_model();
            const bool tiny = run % 2 == 1;
            const double reach = tiny ? 5 : static_cast<double>(random.integer(10, 45));
            const auto count = tiny ? random.integer(20, 70) : random.integer(4, 34);
            for (std::int64_t i = 0; i < count; ++i) {
                const Corner at = scene.anywhere();
                const Scalar depth = Scalar(random.integer(1, 2)) / 4;
                Corners t;
                for (Corner& c : t) {
                    const auto off = [&] { return std::floor(random.between(-reach, reach) * pixel); };
                    c = {at.x + off(), at.y + off(), depth, 2};
                    if (!in_planes)
                        c.depth = Scalar(random.unit()), c.w = pipeline::exp2(double(random.integer(-1, 5)));
                }
                scene.add(t);
            }
        }
        ASSERT_TRUE(is_same_few(scene, gouraud())) << seed;
    }
}

// ---------------------------------------------------------------------------------------------- equal depths
// Triangles in one plane of constant depth, or in few such planes: what is seen is decided by number alone.
Corners flat(WindowScene& scene, double reach) {
    const Scalar depth = Scalar(scene.random().integer(1, 3)) / 4;
    const double w = pipeline::exp2(static_cast<double>(scene.random().integer(-1, 1)));
    const Corner at = scene.anywhere();
    Corners t;
    for (Corner& c : t) {
        const auto off = [&] { return std::floor(scene.random().between(-reach, reach) * pixel); };
        c = {at.x + off(), at.y + off(), depth, w};
    }
    return t;
}

TEST(Boundary, EqualDepths) {
    for (const View view : {View::Parallel, View::Perspective})
        for (const double reach : {1.5, 3.0, 12.0, 60.0, 200.0})
            for (const int triangles : {4, 16, 64, 700}) {
                WindowScene scene({130, 67}, view, std::uint64_t(triangles));
                for (int i = 0; i < triangles; ++i) {
                    if (i % 37 == 36) scene.next_model();
                    scene.add(flat(scene, i % 5 == 0 ? 4 : reach));
                }
                ASSERT_TRUE(is_same_few(scene)) << "reach " << reach << ", " << triangles;
            }
}

TEST(Boundary, EqualDepthsAcrossChunks) {
    for (const View view : {View::Parallel, View::Perspective}) {
        WindowScene scene({101, 67}, view);
        for (int i = 0; i < 70000; ++i) scene.add(flat(scene, i % 100 == 0 ? 30 : 1.5));
        EXPECT_TRUE(is_same_few(scene));
        EXPECT_TRUE(is_same_few(scene));
    }
}

// Triangles over more than 64 tiles stand in another list than small and middling ones.
TEST(Boundary, EqualDepthsOfWideTriangles) {
    const Size size{301, 289};
    for (const View view : {View::Parallel, View::Perspective})
        for (const int every : {2, 5, 40}) {
            WindowScene scene(size, view, std::uint64_t(every));
            for (int i = 0; i < 200; ++i) {
                Corners t = flat(scene, i % 2 ? 70 : 3);
                if (i % every == 0) {
                    const double w = size.width * pixel, h = size.height * pixel;
                    t[0].x = 0, t[0].y = h / 9, t[1].x = w, t[1].y = 0;
                    t[2].x = std::floor(w * scene.random().unit()), t[2].y = h;
                }
                scene.add(t);
            }
            std::vector<Way> ways = all_ways();
            std::erase_if(ways, [](const Way& way) { return way.tile != 32; });
            ASSERT_TRUE(is_same(scene, ways, textured_phong())) << every;
        }
}

// Needles over 64 tiles each: more numbers than the tiles' lists have room for.
TEST(Boundary, MoreTrianglesThanTheListsHold) {
    const Size size{256, 256};
    WindowScene scene(size, View::Parallel);
    hard::Random& random = scene.random();
    const auto along = [&] { return static_cast<double>(random.integer(1, 30 * 256)); };
    for (int i = 0; i < 160000; ++i) {
        const double end = 255 * pixel;
        const Scalar depth = Scalar(random.integer(1, 3)) / 4;
        const double x0 = along(), y0 = along(), x1 = end - along(), y1 = end - along();
        if (i % 16 == 15)
            scene.add(flat(scene, 2));
        else
            scene.add({Corner{x0, y0, depth}, Corner{x1, y1, depth}, Corner{x1 - 1, y1 + 20, depth}});
    }
    const fast::InstructionSet set = fast::instruction_sets().back();
    EXPECT_TRUE(is_same(scene, {{set, 1, 32}, {set, 7, 32}}, textured_phong()));
}

TEST(Boundary, EqualDepthsOfPiecesAndTriangles) {
    for (const View view : {View::Parallel, View::Perspective})
        for (const int every : {1, 2, 3, 17}) {
            WindowScene scene({130, 67}, view, std::uint64_t(every));
            for (int i = 0; i < 300; ++i) {
                Corners t = flat(scene, 20);
                if (i % every == 0) t[0].x = (scene.random().coin() ? 8 : -8) * 130 * pixel;
                if (i % 50 == 49) scene.next_model();
                scene.add(t);
            }
            ASSERT_TRUE(is_same_few(scene)) << every;
            ASSERT_TRUE(is_same_few(scene, gouraud())) << every;
        }
}

TEST(Boundary, TheSameTrianglesTwice) {
    for (const View view : {View::Parallel, View::Perspective})
        for (const int triangles : {1, 7, 16, 100}) {
            WindowScene scene({130, 67}, view);
            std::vector<Corners> all;
            for (int i = 0; i < triangles; ++i)
                all.push_back({scene.anywhere(10), scene.anywhere(10), scene.anywhere(10)});
            for (int again = 0; again < 4; ++again) {
                for (const Corners& t : all) {
                    scene.add(t);
                    scene.add({t[1], t[2], t[0]});
                }
                if (again % 2) scene.next_model();
            }
            ASSERT_TRUE(is_same_few(scene)) << triangles;
        }
}

// ------------------------------------------------------------------------------------------- small triangles
// Their fragments are kept until all is covered. Here there is no room for all of them: thirty layers, the
// nearest first, last, or anywhere.
TEST(Boundary, MoreFragmentsThanATileKeeps) {
    constexpr int layers = 30, a_layer = 900;
    for (const View view : {View::Parallel, View::Perspective})
        for (const int order : {1, -1, 0})
            for (const int models : {1, 7}) {
                WindowScene scene({64, 60}, view, std::uint64_t(order + 1));
                for (int layer = 0; layer < layers; ++layer) {
                    if (layer % (layers / models) == 0 && layer > 0) scene.next_model();
                    for (int i = 0; i < a_layer; ++i) {
                        Corners t{scene.anywhere(), {}, {}};
                        const double nearer = order == 0  ? scene.random().unit()
                                              : order > 0 ? (layer + 1.0) / (layers + 1)
                                                          : 1 - layer / (layers + 1.0);
                        for (Corner& c : t) {
                            const auto off = [&] { return std::floor(scene.random().between(0, 5) * pixel); };
                            c = {t[0].x + off(), t[0].y + off(), Scalar(nearer), 0.5 + nearer};
                        }
                        scene.add(t);
                    }
                }
                ASSERT_TRUE(is_same_few(scene)) << order << ", " << models << " models";
                ASSERT_TRUE(is_same_few(scene, gouraud())) << order << ", " << models << " models";
            }
}

// Nor for all groups of 16 triangles that show a pixel somewhere.
TEST(Boundary, MoreGroupsThanATileKeeps) {
    std::vector<Way> ways = all_ways();
    std::erase_if(ways, [](const Way& way) { return way.tile != 32 || way.threads == 2; });
    for (const View view : {View::Parallel, View::Perspective})
        for (const raster::Shading shading : {raster::Shading::Unlit, raster::Shading::Flat,
                                              raster::Shading::Gouraud, raster::Shading::Phong})
            for (const bool in_planes : {false, true}) {
                WindowScene scene({34, 33}, view, 11);
                hard::Random& random = scene.random();
                for (int i = 0; i < 60000; ++i) {
                    Corners t{scene.anywhere(), {}, {}};
                    const Scalar plane = Scalar(random.integer(1, 2)) / 4;
                    for (Corner& c : t) {
                        const auto off = [&] { return double(random.integer(-200, 200)); };
                        c = {t[0].x + off(), t[0].y + off(), in_planes ? plane : Scalar(random.unit()),
                             in_planes ? 1 : t[0].w};
                    }
                    scene.add(t);
                }
                Settings settings = textured_phong();
                settings.shading = shading;
                EXPECT_TRUE(is_same(scene, ways, settings)) << int(shading) << in_planes;
            }
}

// Groups whose fragments are kept and groups that are drawn in strips, in the same planes, in all orders.
TEST(Boundary, EqualDepthsOfSmallAndLargeTriangles) {
    for (const View view : {View::Parallel, View::Perspective})
        for (const int run : {16, 23, 48})
            for (const int every : {1000, 5, 40}) {
                WindowScene scene({130, 67}, view, std::uint64_t(run));
                for (int i = 0; i < 900; ++i) {
                    if (i % every == every - 1) scene.next_model();
                    scene.add(flat(scene, i / run % 2 ? 60 : 2));
                }
                ASSERT_TRUE(is_same_few(scene)) << run;
                ASSERT_TRUE(is_same_few(scene, gouraud())) << run;
            }
}

// --------------------------------------------------------------------------------------------- odd triangles
TEST(Boundary, SliversAndTrianglesWithoutArea) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Size size{150, 140};
        WindowScene scene(size, seed % 2 ? View::Perspective : View::Parallel, seed);
        hard::Random& random = scene.random();
        for (int i = 0; i < 150; ++i) {
            Corners t{scene.anywhere(300), scene.anywhere(300), scene.anywhere(300)};
            const auto near = [&](const Corner& c, std::int64_t by) {
                Corner out = c;
                out.x += double(random.integer(-by, by)), out.y += double(random.integer(-by, by));
                return out;
            };
            switch (i % 6) {
                case 0:
                    t[2] = near(t[0], 1);
                    break;  // a needle
                case 1:
                    t[1] = near(t[0], 0), t[2] = near(t[0], 0);
                    break;  // a point
                case 2:
                    t[1] = near(t[0], 200), t[2] = near(t[0], 200);
                    break;  // a pixel
                case 3:     // a line
                    t[2].x = 2 * t[1].x - t[0].x, t[2].y = 2 * t[1].y - t[0].y;
                    break;
                case 4:  // almost
                    t[2].x = 2 * t[1].x - t[0].x + 1, t[2].y = 2 * t[1].y - t[0].y;
                    break;
                default:
                    t[1].y = t[0].y, t[2].y = t[0].y + double(random.integer(-1, 1));
            }
            scene.add(t);
        }
        ASSERT_TRUE(is_same_few(scene)) << seed;
    }
}

TEST(Boundary, EdgesThroughPixelCentres) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Size size{127, 129};
        WindowScene scene(size, seed % 2 ? View::Perspective : View::Parallel, seed);
        hard::Screen screen{hard::Random(seed), size.width, size.height};
        for (int i = 0; i < 60; ++i) {
            const hard::ScreenTriangle near = hard::near_tie(screen, int(scene.random().integer(-2, 2)));
            Corners t;
            bool fits = true;
            for (std::size_t k = 0; k < 3; ++k) {
                t[k] = {near[k].x * pixel, near[k].y * pixel, Scalar(scene.random().unit()), 1};
                fits &= std::abs(near[k].x) < 400 && std::abs(near[k].y) < 400;
            }
            if (fits) scene.add(t);
            Corners centres;  // all corners on centres, or on the grid of pixels
            for (Corner& c : centres) {
                c = scene.anywhere(10);
                const double off = i % 2 ? 128 : 0;
                c.x = std::floor(c.x / pixel) * pixel + off, c.y = std::floor(c.y / pixel) * pixel + off;
            }
            scene.add(centres);
        }
        ASSERT_TRUE(is_same_few(scene)) << seed;
    }
}

// ------------------------------------------------------------------------------------ guard band, largest
TEST(Boundary, TheEdgeOfTheGuardBand) {
    for (const Size size : {Size{64, 64}, Size{301, 33}, Size{8192, 3}, Size{3, 8192}})
        for (const double ratio : {1 - 0x1p-23, 1.0, 1 + 0x1p-22}) {
            WindowScene scene(size, View::Parallel, 2);
            const double half_width = 128.0 * size.width, half_height = 128.0 * size.height;
            for (int i = 0; i < 40; ++i) {
                Corners t{scene.anywhere(), scene.anywhere(), scene.anywhere()};
                for (int k = 0; k < 3; ++k) {
                    if (scene.random().coin()) continue;
                    Corner& c = t[std::size_t(k)];
                    const double side = scene.random().coin() ? 7 * ratio : -7 * ratio;
                    if (scene.random().coin())
                        c.x = half_width + side * half_width;
                    else
                        c.y = half_height + side * half_height;
                }
                scene.add(t);
            }
            ASSERT_TRUE(is_same_few(scene)) << size.width << ", " << ratio;
        }
}

TEST(Boundary, TheLargestCoordinates) {
    constexpr double most = 0x1p23, least = -6 * 0x1p20;  // of a picture of 8192 pixels
    for (const Size size : {Size{8192, 3}, Size{3, 8192}}) {
        WindowScene scene(size, View::Parallel);
        const double mid = 1.5 * pixel;
        const auto at = [&](double along, double across, Scalar depth) {
            return size.width > size.height ? Corner{along, across, depth, 1}
                                            : Corner{across, along, depth, 1};
        };
        for (int i = 0; i < 10; ++i) {
            const auto d = [&] { return Scalar(scene.random().unit()); };
            const auto across = [&] { return std::floor(mid + scene.random().between(-9, 9) * pixel); };
            scene.add({at(least, across(), d()), at(most, across(), d()), at(1e5, across(), d())});
            scene.add({at(most, across(), d()), at(most, across(), d()), at(least, across(), d())});
            scene.add({at(least, -9 * pixel, d()), at(most, across(), d()), at(most, 10 * pixel, d())});
        }
        for (int i = 0; i < 2000; ++i) {
            Corners t = flat(scene, 3);
            t[0].depth = Scalar(scene.random().unit());
            scene.add(t);
        }
        EXPECT_TRUE(is_same_all(scene));
        EXPECT_TRUE(is_same_few(scene, gouraud()));
    }
}

// An edge from one corner of the guard band to the other changes by as much as it can from pixel to pixel.
TEST(Boundary, TheLongestDiagonals) {
    constexpr double right = 0x1p23, left = -6 * 0x1p20, below = right / 4, above = left / 4;
    WindowScene scene({8192, 2048}, View::Parallel);
    const auto beside = [&](double x) { return x - std::floor(scene.random().between(0, 18) * pixel); };
    for (int i = 0; i < 12; ++i) {
        const Scalar depth = Scalar(scene.random().unit());
        const bool falling = i % 2;
        const Corner from{left, falling ? above : beside(below), depth},
            to{beside(right), falling ? below : above, depth};
        scene.add({from, to, i % 4 < 2 ? Corner{from.x, to.y, depth} : Corner{to.x, from.y, depth}});
    }
    std::vector<Way> ways;
    for (const Way& way : few_ways(0)) ways.push_back({way.set, 2, 128, false, true});
    EXPECT_TRUE(is_same(scene, ways, gouraud()));
}

}  // namespace
}  // namespace relevo::tests::identity
