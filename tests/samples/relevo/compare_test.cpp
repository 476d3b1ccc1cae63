// `relevo compare`: exit status, words, JSON, the picture of the difference.
#include <gtest/gtest.h>

#include "samples/io/picture.hpp"
#include "samples/io/png.hpp"
#include "tests/samples/relevo/program.hpp"

namespace relevo::command {
namespace {

using io::TemporaryFolder;
using raster::Image;
using raster::Rgba8;

// a.png, b.png (one pixel differs by 10) and small.png.
void write_pictures(const TemporaryFolder& folder) {
    Image<Rgba8> image(8, 4, {10, 20, 30, 255});
    ASSERT_FALSE(io::write_png(folder.path("a.png"), image));
    image.at(5, 2).g = 30;
    ASSERT_FALSE(io::write_png(folder.path("b.png"), image));
    ASSERT_FALSE(io::write_png(folder.path("small.png"), Image<Rgba8>(4, 4)));
}

TEST(Compare, TheSame) {
    const TemporaryFolder folder;
    write_pictures(folder);
    const Outcome outcome = run(folder, "compare a.png a.png");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "a.png and a.png are the same: 8 x 4 pixels, 3 channels, every number equal\n");
    EXPECT_EQ(outcome.err, "");
}

TEST(Compare, Different) {
    const TemporaryFolder folder;
    write_pictures(folder);
    const Outcome outcome = run(folder, "compare a.png b.png -o d.png");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out,
              "a.png and b.png differ in 1 of 32 pixels (3.12 %)\n"
              "  first wrong pixel  x 5, y 2: 10 20 30 against 10 30 30, difference 10\n"
              "  worst pixel        x 5, y 2: 10 20 30 against 10 30 30, difference 10\n");
    const auto picture = io::read_image(folder.path("d.png"));
    ASSERT_TRUE(picture) << picture.error().text();
    EXPECT_EQ(picture->width(), 3 * 8 + 2);
    EXPECT_EQ(picture->at(18 + 5, 2), (Rgba8{0, 80, 0, 255}));
}

TEST(Compare, NotComparable) {
    const TemporaryFolder folder;
    write_pictures(folder);
    const Outcome sizes = run(folder, "compare a.png small.png -o d.png");
    EXPECT_EQ(sizes.status, 2);
    EXPECT_EQ(sizes.err,
              "a.png and small.png cannot be compared: the sizes are 8 x 4 pixels and 4 x 4 pixels\n");
    const Outcome missing = run(folder, "compare a.png c.png -o d.png");
    EXPECT_EQ(missing.status, 2);
    EXPECT_EQ(missing.err, "c.png: there is no such file\n");
    EXPECT_EQ(missing.out + sizes.out, "");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png", "b.png", "small.png"}));
}

TEST(Compare, ADifferencePictureThatCannotBeWritten) {
    const TemporaryFolder folder;
    write_pictures(folder);
    const Outcome outcome = run(folder, "compare a.png b.png -o no/d.png");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "no/d.png: cannot be written: No such file or directory\n");
}

TEST(Compare, Json) {
    const TemporaryFolder folder;
    write_pictures(folder);
    const Outcome outcome = run(folder, "compare a.png b.png --json | tr -d ' \\n'; exit ${PIPESTATUS[0]}");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out,
              R"({"a":"a.png","b":"b.png","result":"different","width":8,"height":4,"channels":3,)"
              R"("different_pixels":1,"first":{"x":5,"y":2,"a":[10.0,20.0,30.0],"b":[10.0,30.0,30.0],)"
              R"("difference":10.0},"worst":{"x":5,"y":2,"a":[10.0,20.0,30.0],"b":[10.0,30.0,30.0],)"
              R"("difference":10.0}})");
    const Outcome sizes = run(folder, "compare a.png small.png --json | tr -d ' \\n'; exit ${PIPESTATUS[0]}");
    EXPECT_EQ(sizes.status, 2);
    EXPECT_EQ(
        sizes.out,
        R"({"a":"a.png","b":"small.png","result":"notcomparable","reason":"thesizesare8x4pixelsand4x4pixels"})");
}

}  // namespace
}  // namespace relevo::command
