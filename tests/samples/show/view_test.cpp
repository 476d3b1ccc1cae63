#include "samples/show/view.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace relevo::show {
namespace {

Box unit_box() {
    Box box;
    box.add({0, 0, 0}), box.add({1, 1, 1});
    return box;
}

TEST(View, FitsABoxIntoAnArea) {
    const Rect area{10, 20, 300, 200};
    for (View view : {oblique_view(), side_view(), top_view(), front_view(), view_across({0, 0, 1}),
                      view_across({1, 0, 0})}) {
        view = fitted(view, unit_box(), area, 15);
        bool touches = false;
        for (int i = 0; i < 8; ++i) {
            const Spot s = view.spot(unit_box().corner(i));
            EXPECT_GE(s.x, 25 - 1e-9);
            EXPECT_LE(s.x, 295 + 1e-9);
            EXPECT_GE(s.y, 35 - 1e-9);
            EXPECT_LE(s.y, 205 + 1e-9);
            touches |= std::abs(s.y - 35) < 1e-6 || std::abs(s.x - 25) < 1e-6;
        }
        EXPECT_TRUE(touches) << "the area is used";
    }
}

TEST(View, RunsItsAxesAsItSays) {
    EXPECT_GT(side_view().spot({0, 0, -1}).x, side_view().spot({0, 0, 0}).x);
    EXPECT_LT(side_view().spot({0, 1, 0}).y, side_view().spot({0, 0, 0}).y);
    EXPECT_GT(top_view().spot({1, 0, 0}).x, top_view().spot({0, 0, 0}).x);
    EXPECT_LT(top_view().spot({0, 0, -1}).y, top_view().spot({0, 0, 0}).y);
    EXPECT_GT(oblique_view().depth({0, 0, 1}), oblique_view().depth({0, 0, 0}));
}

TEST(View, ABoxLeavesOutWhatIsNotFinite) {
    Box box = unit_box();
    box.add({std::numeric_limits<double>::infinity(), 0, 0});
    box.add({0, std::nan(""), 0});
    EXPECT_EQ(box.size(), glm::dvec3(1, 1, 1));
}

TEST(Segments, AreKeptOnce) {
    const Segment a{{0, 0, 0}, {1, 0, 0}}, turned{{1, 0, 0}, {0, 0, 0}}, other{{0, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(unique_segments({a, turned, other, a, {{0, 0, 0}, {std::nan(""), 0, 0}}}).size(), 2u);
}

TEST(Segments, ATetrahedronHasSixEdges) {
    pipeline::Mesh mesh;
    mesh.vertices.resize(4);
    mesh.indices = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
    const std::vector<glm::dvec3> places{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    EXPECT_EQ(mesh_edges(mesh, places).size(), 6u);
}

TEST(Wire, BecomesFainterTheDenserItIs) {
    const View view = fitted(front_view(), unit_box(), {0, 0, 400, 400}, 0);
    std::vector<Segment> few, many;
    for (int i = 0; i < 2000; ++i)
        (i < 8 ? few : many).push_back({{0, i / 2000.0, 0}, {1, 1 - i / 2000.0, 0}});
    EXPECT_EQ(wire_stroke(view, few, {0, 0, 400, 400}, ink).color.a, 255);
    EXPECT_LT(wire_stroke(view, many, {0, 0, 400, 400}, ink).color.a, 80);
    EXPECT_LT(wire_stroke(view, many, {0, 0, 400, 400}, ink).width, 1);
}

TEST(Solid, HidesWhatIsBehindIt) {
    pipeline::Mesh mesh;  // a square in the plane z = 0
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        mesh.vertices.push_back({{pipeline::Vec3(x, y, 0)}, {pipeline::Vec3(0, 0, 1)}, {}});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    const raster::Model model{&mesh, {}, {}, nullptr, false};
    Box box;
    box.add({-2, -2, -1}), box.add({2, 2, 1});
    const Rect area{0, 0, 100, 100};
    const View view = fitted(front_view(), box, area, 0);
    const Solid solid = draw_solid(view, area, std::span(&model, 1));
    const auto middle_of = [&](double z) {
        Picture picture(100, 100, paper);
        const std::vector<Segment> wire{{{-2, 0, z}, {2, 0, z}}};
        draw_wire(canvas_of(picture), view, solid, wire, {{0, 0, 0}, 3}, {{200, 0, 0}, 3});
        return std::pair(picture.at(50, 50), picture.at(5, 50));
    };
    EXPECT_EQ(middle_of(1).first, (Rgba8{0, 0, 0}));
    EXPECT_EQ(middle_of(-1).first, (Rgba8{200, 0, 0}));
    EXPECT_EQ(middle_of(-1).second, (Rgba8{0, 0, 0})) << "beside the square nothing hides it";
}

}  // namespace
}  // namespace relevo::show
