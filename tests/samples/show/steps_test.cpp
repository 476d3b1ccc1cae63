// The folder that `relevo steps` writes: exactly its files, the same bytes each time, all or nothing.
#include "samples/show/steps.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "samples/show/stages.hpp"
#include "tests/samples/io/size_limit.hpp"
#include "tests/samples/io/temporary_folder.hpp"
#include "tests/samples/show/scenes.hpp"

namespace relevo::show {
namespace {

using io::bytes_of;
using io::TemporaryFolder;

std::vector<std::string> all_files() {
    std::vector<std::string> files;
    for (std::size_t i = 0; i < stages().size(); ++i) files.push_back(stage_file(i));
    files.insert(files.end(), {"index.html", "steps.json", "strip.png", "timing.json"});
    return files;
}

std::vector<std::string> names_in(const std::string& directory) {
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(directory))
        out.push_back(entry.path().filename().string());
    std::sort(out.begin(), out.end());
    return out;
}

TEST(Steps, WritesExactlyItsFilesTheSameEachTime) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(cube_scene);
    const std::string one = folder.path("a/b/one"), two = folder.path("two");
    ASSERT_EQ(write_steps(loaded, {one, {}}), std::nullopt);
    ASSERT_EQ(write_steps(loaded, {two, {}}), std::nullopt);
    EXPECT_EQ(names_in(one), all_files());
    for (const std::string& file : all_files())
        if (file != "timing.json") {
            EXPECT_TRUE(bytes_of(one + "/" + file) == bytes_of(two + "/" + file)) << file;
        }
}

TEST(Steps, ListsStagesWithFileCaptionAndCounts) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(cube_scene);
    ASSERT_EQ(write_steps(loaded, {folder.path("out"), {}}), std::nullopt);
    const auto steps = nlohmann::json::parse(bytes_of(folder.path("out/steps.json")));
    const auto timing = nlohmann::json::parse(bytes_of(folder.path("out/timing.json")));
    ASSERT_EQ(steps["stages"].size(), stages().size());
    for (std::size_t i = 0; i < stages().size(); ++i) {
        EXPECT_EQ(steps["stages"][i]["stage"], stages()[i].name);
        EXPECT_EQ(steps["stages"][i]["file"], stage_file(i));
        EXPECT_EQ(steps["stages"][i]["caption"], stages()[i].sentence);
        EXPECT_TRUE(steps["stages"][i]["counts"].is_object());
        EXPECT_EQ(timing["stages"][i]["stage"], stages()[i].name);
        EXPECT_GE(timing["stages"][i]["draw_ms"], 0);
    }
    EXPECT_EQ(bytes_of(folder.path("out/steps.json")).find("_ms"), std::string::npos)
        << "no times in steps.json";
}

TEST(Steps, ThePageNeedsNothingFromOutside) {
    const TemporaryFolder folder;
    scene::LoadedScene loaded = loaded_scene(cube_scene);
    loaded.name = "<b>&\"";
    ASSERT_EQ(write_steps(loaded, {folder.path("out"), {"object", "final"}}), std::nullopt);
    const std::string page = bytes_of(folder.path("out/index.html"));
    for (const char* forbidden : {"http:", "https:", "<script", "@import", "url(", "<b>"})
        EXPECT_EQ(page.find(forbidden), std::string::npos) << forbidden;
    for (const char* wanted :
         {"01-object.png", "17-final.png", "&lt;b&gt;&amp;&quot;", "lang=\"en\"", "width=device-width"})
        EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
    EXPECT_EQ(page.find("07-window.png"), std::string::npos) << "only the chosen stages";
}

TEST(Steps, DrawsOnlyTheChosenStagesInTheirOrder) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(cube_scene);
    ASSERT_EQ(write_steps(loaded, {folder.path("out"), {"depth", "object", "depth"}}), std::nullopt);
    EXPECT_EQ(names_in(folder.path("out")),
              (std::vector<std::string>{"01-object.png", "10-depth.png", "index.html", "steps.json",
                                        "strip.png", "timing.json"}));
}

TEST(Steps, AnUnknownStageIsRefusedWithASuggestion) {
    const TemporaryFolder folder;
    const auto failure = write_steps(loaded_scene(cube_scene), {folder.path("out"), {"object", "gourad"}});
    ASSERT_TRUE(failure);
    EXPECT_EQ(
        failure->text(),
        "--stage: there is no stage 'gourad', did you mean 'gouraud'? (stages: object, world, eye, "
        "clip, clipped, ndc, "
        "window, culled, coverage, depth, visibility, attributes, flat, gouraud, phong, texture, final)");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Steps, ATooLargePictureIsRefused) {
    const TemporaryFolder folder;
    scene::LoadedScene loaded = loaded_scene(cube_scene);
    loaded.width = 2049;
    const auto failure = write_steps(loaded, {folder.path("out"), {}});
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->text(),
              "scene.toml: a picture of 2049x30 is too large for steps, at most 2048x2048 (choose one with "
              "--size)");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Steps, AFileInPlaceOfTheFolderIsRefused) {
    const TemporaryFolder folder;
    const std::string file = folder.write("taken", "old");
    for (const std::string& target : {file, file + "/below"}) {
        const auto failure = write_steps(loaded_scene(cube_scene), {target, {"object"}});
        ASSERT_TRUE(failure);
        EXPECT_EQ(failure->place.file, target);
        EXPECT_EQ(failure->text().find('\n'), std::string::npos);
    }
    EXPECT_EQ(bytes_of(file), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"taken"});
}

TEST(Steps, AFullDiskLeavesNothingBehind) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(cube_scene);
    const std::string kept = folder.path("kept");
    std::filesystem::create_directory(kept);
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    {
        const io::SizeLimit limit(2000);
        for (const std::string& target : {folder.path("new/deep"), kept}) {
            const auto failure = write_steps(loaded, {target, {"object", "final"}});
            ASSERT_TRUE(failure);
            EXPECT_EQ(failure->place.file, target + "/01-object.png");
        }
    }
    std::signal(SIGXFSZ, before);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"kept"});
    EXPECT_TRUE(names_in(kept).empty());
}

TEST(Steps, OldPicturesStayUntilTheNewOnesAreComplete) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(cube_scene);
    std::filesystem::create_directory(folder.path("out"));
    folder.write("out/01-object.png", "old picture");
    folder.write("out/mine.txt", "not ours");
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    {
        const io::SizeLimit limit(2000);
        EXPECT_TRUE(write_steps(loaded, {folder.path("out"), {"object"}}));
    }
    std::signal(SIGXFSZ, before);
    EXPECT_EQ(bytes_of(folder.path("out/01-object.png")), "old picture");
    EXPECT_EQ(write_steps(loaded, {folder.path("out"), {"object"}}), std::nullopt);
    EXPECT_NE(bytes_of(folder.path("out/01-object.png")), "old picture");
    EXPECT_EQ(bytes_of(folder.path("out/mine.txt")), "not ours");
}

}  // namespace
}  // namespace relevo::show
