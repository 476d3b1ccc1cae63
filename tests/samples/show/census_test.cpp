// Which triangles cross which plane, and what is left of them, on cases that can be told by hand.
#include "samples/show/census.hpp"

#include <gtest/gtest.h>

#include "tests/samples/show/scenes.hpp"

namespace relevo::show {
namespace {

// A parallel camera that sees -1..1 x -1..1, at distances 0 to 2 from z = 1 on; a unit square, moved and
// stretched.
scene::LoadedScene square_scene(const std::string& transform, const std::string& pipeline = "") {
    return loaded_scene(R"([image]
width = 32
height = 32
[camera]
projection = "orthographic"
height = 2
eye = [0, 0, 1]
target = [0, 0, 0]
near = 0
far = 2
[[object]]
mesh = "plane"
segments = [1, 1]
transform = [{ rotate = { axis = [1, 0, 0], degrees = 90 } }, )" +
                        transform + "]\n" + pipeline);
}

std::array<std::int64_t, 4> totals(const std::string& transform) {
    const scene::LoadedScene loaded = square_scene(transform);
    return take_census(capture(loaded)).total;
}

using Totals = std::array<std::int64_t, 4>;

TEST(Census, KnowsInsideCrossingAndOutside) {
    EXPECT_EQ(totals("{ scale = 1 }"), (Totals{2, 0, 0, 0}));
    EXPECT_EQ(totals("{ scale = 4 }"), (Totals{0, 2, 0, 0}));
    EXPECT_EQ(totals("{ translate = [5, 0, 0] }"), (Totals{0, 0, 2, 0}));
    EXPECT_EQ(totals("{ translate = [0, 0, 3] }"), (Totals{0, 0, 2, 0}));
}

TEST(Census, NamesThePlane) {
    struct Case {
        const char* transform;
        std::size_t plane;
    };
    const Case cases[] = {{"{ translate = [0, 0, 3] }", 0},  {"{ translate = [0, 0, -3] }", 1},
                          {"{ translate = [-4, 0, 0] }", 2}, {"{ translate = [4, 0, 0] }", 3},
                          {"{ translate = [0, -4, 0] }", 4}, {"{ translate = [0, 4, 0] }", 5}};
    for (const char* depth : {"", "[pipeline]\ndepth = \"float32-forward\"\n"})
        for (const Case& c : cases) {
            const scene::LoadedScene loaded = square_scene(c.transform, depth);
            const Census census = take_census(capture(loaded));
            for (std::size_t k = 0; k < 6; ++k)
                EXPECT_EQ(census.planes[k].triangles[2], k == c.plane ? 2 : 0)
                    << c.transform << " at " << census.planes[k].name;
        }
}

TEST(Clipped, ALargeSquareBecomesTheWholePicture) {
    const scene::LoadedScene loaded = square_scene("{ scale = 4 }");
    const Capture seen = capture(loaded);
    const std::vector<ClippedPiece> pieces = clip_to_view_volume(seen, take_census(seen));
    ASSERT_EQ(pieces.size(), 2u);
    double area = 0;
    for (const ClippedPiece& piece : pieces) {
        EXPECT_TRUE(piece.cut);
        for (std::size_t i = 0; i < piece.ndc.size(); ++i) {
            const glm::dvec3 a = piece.ndc[i], b = piece.ndc[(i + 1) % piece.ndc.size()];
            area += (a.x * b.y - a.y * b.x) / 2;
            EXPECT_LE(std::max(std::abs(a.x), std::abs(a.y)), 1);
        }
    }
    EXPECT_NEAR(std::abs(area), 4, 1e-12);
}

TEST(Clipped, MarksTheCornersThatAPlaneMade) {
    const scene::LoadedScene loaded = square_scene("{ translate = [1, 0, 0] }");
    const Capture seen = capture(loaded);
    for (const ClippedPiece& piece : clip_to_view_volume(seen, take_census(seen)))
        for (std::size_t i = 0; i < piece.ndc.size(); ++i)
            EXPECT_EQ(piece.made[i], piece.ndc[i].x == 1) << piece.ndc[i].x;
}

}  // namespace
}  // namespace relevo::show
