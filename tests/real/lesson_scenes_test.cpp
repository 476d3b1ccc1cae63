// Every sample lesson: it is drawn, watched or not the bytes are the same, and its pixels add up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "raster/draw_shapes.hpp"
#include "samples/scene/scene.hpp"
#include "samples/scene/statistics.hpp"

namespace relevo::real {
namespace {

std::vector<std::string> lesson_names() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(RELEVO_SCENES "/lessons"))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}
std::string path_of(const std::string& name) { return RELEVO_SCENES "/lessons/" + name + ".toml"; }

raster::Image<raster::LinearRgb> drawn(const scene::LoadedScene& lesson) {
    raster::Image<raster::LinearRgb> picture(lesson.width, lesson.height);
    raster::draw_shapes(lesson.shapes, picture);
    return picture;
}

TEST(SampleLessons, AreTheFiguresOfTheTextbook) {
    const std::vector<std::string> names = lesson_names();
    for (const char* chapter :
         {"4-2", "4-3", "4-4", "4-5", "4-6", "4-7",  "4-8", "4-9", "5-1", "5-2", "5-3", "5-4",
          "5-5", "5-6", "5-7", "5-8", "5-9", "5-10", "8-1", "8-2", "8-3", "8-4", "8-5", "8-6"})
        EXPECT_TRUE(std::binary_search(names.begin(), names.end(), "figure-" + std::string(chapter)))
            << chapter;
}

TEST(SampleLessons, TogetherUseEveryAlgorithm) {
    std::vector<int> algorithms(10), antialiasings(5), lines(4), polygons(3);
    for (const std::string& name : lesson_names()) {
        const auto lesson = scene::load_scene(path_of(name));
        ASSERT_TRUE(lesson) << lesson.error().text();
        for (const raster::Shape& shape : lesson->shapes.shapes) {
            ++algorithms[std::size_t(shape.algorithm)];
            ++antialiasings[std::size_t(shape.antialiasing)];
        }
        if (!lesson->shapes.clip.on) continue;
        ++lines[std::size_t(lesson->shapes.clip.lines)];
        ++polygons[std::size_t(lesson->shapes.clip.polygons)];
    }
    for (const auto& counts : {algorithms, antialiasings, lines, polygons})
        EXPECT_EQ(std::count(counts.begin(), counts.end(), 0), 0);
}

class SampleLesson : public testing::TestWithParam<std::string> {
  protected:
    void SetUp() override {
        auto loaded = scene::load_scene(path_of(GetParam()));
        ASSERT_TRUE(loaded) << loaded.error().text();
        lesson = std::move(*loaded);
        EXPECT_TRUE(lesson.warnings.empty());
    }
    scene::LoadedScene lesson;
};

struct EveryEvent {
    std::size_t events = 0;
    void on(const auto&) { ++events; }
};

TEST_P(SampleLesson, AProbeChangesNoBit) {
    const auto unwatched = drawn(lesson);
    raster::Image<raster::LinearRgb> watched(lesson.width, lesson.height);
    EveryEvent probe;
    raster::draw_shapes(lesson.shapes, watched, probe);
    EXPECT_GT(probe.events, lesson.shapes.shapes.size());
    EXPECT_EQ(
        std::memcmp(unwatched.row(0), watched.row(0), unwatched.pixels().size() * sizeof(raster::LinearRgb)),
        0);
}

// Every pixel that is not background was painted, and the counts agree with the picture.
TEST_P(SampleLesson, ItsCountsAreThoseOfThePicture) {
    const auto picture = drawn(lesson);
    raster::Image<raster::LinearRgb> again(lesson.width, lesson.height);
    scene::ShapeStatistics statistics(lesson.width, lesson.height);
    raster::draw_shapes(lesson.shapes, again, statistics);
    const auto changed = std::count_if(picture.pixels().begin(), picture.pixels().end(),
                                       [&](const auto& c) { return c != lesson.shapes.background; });
    EXPECT_EQ(statistics.shapes, lesson.shapes.shapes.size());
    EXPECT_EQ(statistics.refused, 0u);
    EXPECT_GT(changed, 5);
    EXPECT_EQ(statistics.lit, std::size_t(changed));
    EXPECT_GE(statistics.painted, statistics.lit);
    EXPECT_LE(statistics.spans, statistics.painted);
}

INSTANTIATE_TEST_SUITE_P(Each, SampleLesson, testing::ValuesIn(lesson_names()), [](const auto& name) {
    std::string word = name.param;
    std::replace(word.begin(), word.end(), '-', '_');
    return word;
});

}  // namespace
}  // namespace relevo::real
