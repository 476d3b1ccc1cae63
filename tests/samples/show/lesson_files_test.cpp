// The folder that `relevo steps` writes for a scene of shapes: exactly its files, tables that agree, films
// that show the frames, all or nothing.
#include "samples/show/lesson_files.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "samples/io/picture.hpp"
#include "samples/io/png_check.hpp"
#include "samples/show/lesson_sheet.hpp"
#include "tests/samples/io/size_limit.hpp"
#include "tests/samples/io/temporary_folder.hpp"
#include "tests/samples/show/demo_lesson.hpp"
#include "tests/samples/show/html_check.hpp"
#include "tests/samples/show/scenes.hpp"

namespace relevo::show {
namespace {

using io::bytes_of;
using io::TemporaryFolder;
using Json = nlohmann::json;

const std::string line_scene = R"([image]
width = 12
height = 9
[[shape2d]]
type = "line"
points = [[0, 0], [7, 3]]
)";

std::vector<Lesson> two_lessons() {
    std::vector<Lesson> lessons{demo_lesson(), demo_lesson()};
    lessons[0].frames.resize(3);
    lessons[1].name = "02-second";
    lessons[1].frames.resize(2);
    return lessons;
}

std::vector<std::string> files_below(const std::string& directory) {
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
        if (!entry.is_directory()) out.push_back(std::filesystem::relative(entry.path(), directory).string());
    std::sort(out.begin(), out.end());
    return out;
}

TEST(Lessons, WriteExactlyTheirFilesTheSameEachTime) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(line_scene);
    const std::string one = folder.path("a/one"), two = folder.path("two");
    for (const std::string& target : {one, two})
        ASSERT_EQ(write_lessons(loaded, two_lessons(), {target, {}}), std::nullopt);
    EXPECT_EQ(files_below(one),
              (std::vector<std::string>{
                  "01-line-midpoint.apng", "01-line-midpoint.csv", "01-line-midpoint.json",
                  "01-line-midpoint.png", "01-line-midpoint/001.png", "01-line-midpoint/002.png",
                  "01-line-midpoint/003.png", "02-second.apng", "02-second.csv", "02-second.json",
                  "02-second.png", "02-second/001.png", "02-second/002.png", "final-enlarged.png",
                  "final.png", "index.html", "steps.json", "timing.json"}));
    for (const std::string& file : files_below(one))
        if (file != "timing.json") {
            EXPECT_TRUE(bytes_of(one + "/" + file) == bytes_of(two + "/" + file)) << file;
        }
}

TEST(Lessons, OfASceneWithShapesTakeThePlaceOfStages) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(line_scene);
    ASSERT_EQ(write_steps(loaded, {folder.path("out"), {}}), std::nullopt);
    const auto names = files_below(folder.path("out"));
    EXPECT_NE(std::find(names.begin(), names.end(), "final.png"), names.end());
    EXPECT_EQ(std::find(names.begin(), names.end(), "01-object.png"), names.end());
}

TEST(Lessons, AreChosenByName) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(line_scene);
    std::vector<Lesson> lessons = two_lessons();
    lessons.push_back(lessons[0]);
    lessons[2].name = "03-line-midpoint";
    const auto written = [&](const std::vector<std::string>& names) {
        const TemporaryFolder target;
        EXPECT_EQ(write_lessons(loaded, lessons, {target.path("out"), names}), std::nullopt);
        std::string out;
        for (const std::string& file : files_below(target.path("out")))
            if (file.ends_with(".csv")) out += file.substr(0, 2) + " ";
        return out;
    };
    EXPECT_EQ(written({"second"}), "02 ");
    EXPECT_EQ(written({"line-midpoint"}), "01 03 ");
    EXPECT_EQ(written({"03-line-midpoint", "second"}), "02 03 ");
    const auto failure = write_lessons(loaded, lessons, {folder.path("out"), {"second", "line-midpiont"}});
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->text(),
              "--stage: there is no lesson 'line-midpiont', did you mean 'line-midpoint'? (lessons: "
              "line-midpoint, second)");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Lessons, TheTableAsCsvQuotesWhatNeedsIt) {
    Lesson lesson = demo_lesson();
    lesson.columns = {"plain", "with, comma", "\"quoted\""};
    lesson.frames.resize(4);
    lesson.frames[0].row = {"1", "2", "3"};
    lesson.frames[1].row = {};
    lesson.frames[2].row = {"a\nb", "c,d", "e\"f", "beyond"};
    lesson.frames[3].row = {" x ", "≥"};
    EXPECT_EQ(
        lesson_csv(lesson),
        "frame,plain,\"with, comma\",\"\"\"quoted\"\"\"\n1,1,2,3\n3,\"a\nb\",\"c,d\",\"e\"\"f\"\n4, x ,≥,\n");
}

TEST(Lessons, TheJsonHoldsTheSameTableAndAllWords) {
    const Lesson lesson = demo_lesson();
    const Json json = Json::parse(lesson_json(lesson, {3, 8, true}));
    EXPECT_EQ(json["title"], lesson.title);
    EXPECT_EQ(json["source"], lesson.source);
    EXPECT_EQ(json["axes"], (Json{{"left", 3}, {"top", 8}, {"y", "up"}}));
    EXPECT_EQ(json["columns"], lesson.columns);
    ASSERT_EQ(json["frames"].size(), lesson.frames.size());
    std::string csv = "frame,x,y,d,choice\n";
    for (std::size_t i = 0; i < lesson.frames.size(); ++i) {
        const Json& frame = json["frames"][i];
        EXPECT_EQ(frame["frame"], i + 1);
        EXPECT_EQ(frame["title"], lesson.frames[i].title);
        EXPECT_EQ(frame["equation"], lesson.frames[i].equation);
        EXPECT_EQ(frame["caption"], lesson.frames[i].caption);
        EXPECT_EQ(frame["file"], lesson_frame_file(lesson, i));
        csv += std::to_string(i + 1);
        for (const Json& cell : frame["row"]) csv += "," + cell.get<std::string>();
        csv += "\n";
    }
    EXPECT_EQ(csv, lesson_csv(lesson));
    Lesson broken = lesson;
    broken.title = "no UTF-8: \xff";
    EXPECT_TRUE(Json::accept(lesson_json(broken, {})));
}

TEST(Lessons, PicturesAreThoseOfTheFrames) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(line_scene);
    const std::vector<Lesson> lessons = two_lessons();
    ASSERT_EQ(write_lessons(loaded, lessons, {folder.path("out"), {"second"}}), std::nullopt);
    const auto read = [&](const std::string& name) {
        const auto image = io::read_image(folder.path("out/" + name));
        EXPECT_TRUE(image) << name;
        return *image;
    };
    EXPECT_EQ(read("02-second/002.png").pixels(),
              draw_lesson_frame(lessons[1], loaded.axes, 1).picture.pixels());
    EXPECT_EQ(read("02-second.apng").pixels(), read("02-second/001.png").pixels())
        << "a still for other readers";
    EXPECT_EQ(read("02-second.png").pixels(), draw_lesson_strip(lessons[1], loaded.axes).pixels());
    const std::string film = bytes_of(folder.path("out/02-second.apng"));
    EXPECT_EQ(io::big_endian_32(film, film.find("acTL") + 4), 2u) << "two frames";
    const Picture small = read("final.png"), large = read("final-enlarged.png");
    ASSERT_EQ(small.width(), 12);
    ASSERT_EQ(large.width(), 960);
    EXPECT_EQ(large.height(), 720);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 12; ++x) EXPECT_EQ(small.at(x, y), large.at(80 * x + 79, 80 * y));
}

TEST(Lessons, TheListNamesFilesThatAreThere) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(line_scene);
    ASSERT_EQ(write_lessons(loaded, two_lessons(), {folder.path("out"), {}}), std::nullopt);
    const Json steps = Json::parse(bytes_of(folder.path("out/steps.json")));
    ASSERT_EQ(steps["lessons"].size(), 2u);
    for (const Json& lesson : steps["lessons"])
        for (const Json& file : {lesson["first_frame"], lesson["strip"], lesson["film"], lesson["table"][0],
                                 lesson["table"][1], steps["final"]})
            EXPECT_TRUE(std::filesystem::exists(folder.path("out/" + file.get<std::string>()))) << file;
    EXPECT_EQ(bytes_of(folder.path("out/steps.json")).find("_ms"), std::string::npos) << "no times";
    const Json timing = Json::parse(bytes_of(folder.path("out/timing.json")));
    EXPECT_EQ(timing["lessons"][1]["lesson"], "02-second");
    EXPECT_GE(timing["lessons"][1]["draw_ms"], 0);
}

TEST(Lessons, ThePageIsWellFormedAndNeedsNothingFromOutside) {
    const TemporaryFolder folder;
    scene::LoadedScene loaded = loaded_scene(line_scene);
    loaded.name = "<b>&\"";
    std::vector<Lesson> lessons = two_lessons();
    lessons[1].title = lessons[1].frames[1].title = "a < b & \"c\"";
    lessons[1].frames[1].equation = "d <= \"0\" && true";
    lessons[1].frames[1].row[3] = "<i>";
    ASSERT_EQ(write_lessons(loaded, lessons, {folder.path("out"), {}}), std::nullopt);
    const std::string page = bytes_of(folder.path("out/index.html"));
    const HtmlCheck check = checked_html(page);
    EXPECT_EQ(check.mistake, "");
    for (const std::string& file : check.files)
        EXPECT_TRUE(std::filesystem::exists(folder.path("out/" + file))) << file;
    for (const std::string& file : files_below(folder.path("out")))
        if (file != "index.html" && !(file == "final.png")) {
            EXPECT_NE(std::find(check.files.begin(), check.files.end(), file), check.files.end()) << file;
        }
    for (const char* forbidden : {"http:", "https:", "@import", "url(", "<b>", "<i>"})
        EXPECT_EQ(page.find(forbidden), std::string::npos) << forbidden;
    for (const char* wanted :
         {"lang=\"en\"", "width=device-width", "aria-label", "@media print", "prefers-color-scheme: dark",
          "alt=\"Frame 2: a &lt; b &amp; &quot;c&quot;. d &lt;= &quot;0&quot; &amp;&amp; true.",
          "<p class=\"equation\">d &lt;= &quot;0&quot; &amp;&amp; true</p>", "<td>&lt;i&gt;</td>",
          "<tr data-frame=\"2\">"})
        EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
}

TEST(Lessons, ASceneWithoutLessonsStillHasAPage) {
    const TemporaryFolder folder;
    ASSERT_EQ(write_lessons(loaded_scene(line_scene), {}, {folder.path("out"), {}}), std::nullopt);
    EXPECT_EQ(checked_html(bytes_of(folder.path("out/index.html"))).mistake, "");
    EXPECT_TRUE(std::filesystem::exists(folder.path("out/final.png")));
}

TEST(Lessons, AFullDiskLeavesNothingBehind) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(line_scene);
    std::filesystem::create_directory(folder.path("kept"));
    folder.write("kept/01-line-midpoint.csv", "old");
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    {
        const io::SizeLimit limit(30000);
        for (const std::string& target : {folder.path("new/deep"), folder.path("kept")}) {
            const auto failure = write_lessons(loaded, two_lessons(), {target, {}});
            ASSERT_TRUE(failure);
            EXPECT_EQ(failure->text(),
                      target + "/01-line-midpoint/001.png: cannot be written: File too large");
        }
    }
    std::signal(SIGXFSZ, before);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"kept"});
    EXPECT_EQ(files_below(folder.path("kept")), std::vector<std::string>{"01-line-midpoint.csv"});
    EXPECT_EQ(bytes_of(folder.path("kept/01-line-midpoint.csv")), "old");
}

TEST(Lessons, ATooLargePictureIsRefused) {
    const TemporaryFolder folder;
    scene::LoadedScene loaded = loaded_scene(line_scene);
    loaded.height = 2049;
    const auto failure = write_lessons(loaded, two_lessons(), {folder.path("out"), {}});
    ASSERT_TRUE(failure);
    EXPECT_NE(failure->text().find("a picture of 12x2049 is too large for steps"), std::string::npos);
    EXPECT_TRUE(folder.names().empty());
}

// The check itself can fail.
TEST(HtmlCheck, SeesMistakes) {
    EXPECT_EQ(checked_html("<p id=\"a\">x<img src=\"y\"><a href=\"#a\">z</a></p>").mistake, "");
    for (const char* page : {"<p>", "<p></b></p>", "</p>", "<p class=a></p>",
                             "<p id=\"a\"></p><p id=\"a\"></p>", "<a href=\"#b\"></a>", "<p>a & b</p>", "<p"})
        EXPECT_NE(checked_html(page).mistake, "") << page;
}

}  // namespace
}  // namespace relevo::show
