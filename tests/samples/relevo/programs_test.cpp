// The small programs beside `relevo`: those of samples/minimal, and the one that makes the textures.
#include <gtest/gtest.h>

#include <algorithm>

#include "samples/io/picture.hpp"
#include "tests/samples/relevo/program.hpp"

namespace relevo::command {
namespace {

using io::TemporaryFolder;

TEST(Minimal, TheTeapotProgramDrawsATeapot) {
    const TemporaryFolder folder;
    EXPECT_EQ(shell(folder, "'" MINIMAL_TEAPOT "'").status, 0);
    const auto picture = io::read_image(folder.path("teapot.png"));
    ASSERT_TRUE(picture);
    const raster::Rgba8 background = picture->at(0, 0), body = picture->at(320, 280);
    EXPECT_GT(body.b, background.b + 40);
    EXPECT_GT(body.b, body.r);
    EXPECT_EQ(shell(folder, "'" MINIMAL_TEAPOT "' missing/x.png").status, 2);
}

TEST(Minimal, TheTriangleProgramCountsItsPixels) {
    const TemporaryFolder folder;
    const Outcome outcome = shell(folder, "'" MINIMAL_TRIANGLE "' t.png");
    EXPECT_EQ(outcome.status, 0);
    const auto picture = io::read_image(folder.path("t.png"));
    ASSERT_TRUE(picture);
    const auto drawn = std::count_if(picture->pixels().begin(), picture->pixels().end(),
                                     [&](raster::Rgba8 c) { return c != picture->at(0, 0); });
    EXPECT_EQ(outcome.out, std::to_string(drawn) + " pixels\n");
    EXPECT_NEAR(static_cast<double>(drawn), 0.8 * 160 * 1.4 * 120, 200);  // half of base x height
}

// Five views of one relief texture; the middle one, straight at it, shows the most of the teapot.
TEST(Minimal, TheReliefProgramDrawsFiveViews) {
    const TemporaryFolder folder;
    ASSERT_EQ(shell(folder, "'" MINIMAL_RELIEF "' r.png").status, 0);
    const auto picture = io::read_image(folder.path("r.png"));
    ASSERT_TRUE(picture);
    ASSERT_EQ(picture->width(), 5 * picture->height());
    const int size = picture->height();
    for (int k = 0; k < 5; ++k) {
        int drawn = 0;
        for (int y = 0; y < size; ++y)
            for (int x = k * size; x < (k + 1) * size; ++x) drawn += picture->at(x, y) != picture->at(0, 0);
        EXPECT_GT(drawn, size * size / 8) << "view " << k;
        EXPECT_LT(drawn, size * size / 2) << "view " << k;
    }
}

TEST(Minimal, IsShort) {
    for (const char* name : {"relief", "teapot", "triangle"}) {
        const std::string text =
            io::bytes_of(RELEVO_SOURCE_DIR "/samples/minimal/" + std::string(name) + ".cpp");
        EXPECT_GT(text.size(), 0u);
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 40) << name;
    }
}

TEST(Textures, AreTheOnesThatTheProgramMakes) {
    const TemporaryFolder folder;
    ASSERT_EQ(shell(folder, "'" MAKE_TEXTURES "' .").status, 0);
    EXPECT_EQ(folder.names().size(), 4u);
    for (const std::string& name : folder.names()) {
        const auto made = io::read_image(folder.path(name));
        const auto stored = io::read_image(RELEVO_SOURCE_DIR "/samples/textures/" + name);
        ASSERT_TRUE(made && stored) << name;
        EXPECT_EQ(made->pixels(), stored->pixels()) << name;
    }
}

}  // namespace
}  // namespace relevo::command
