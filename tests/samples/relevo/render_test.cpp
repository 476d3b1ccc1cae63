// relevo render from outside: pictures, exit status, one clear line for what is wrong, nothing half-written.
#include <gtest/gtest.h>

#include <algorithm>

#include "raster/fast/draw_fast.hpp"
#include "samples/io/picture.hpp"
#include "tests/samples/relevo/program.hpp"

namespace relevo::command {
namespace {

using io::TemporaryFolder;
using Names = std::vector<std::string>;

const char* const small = "[image]\nwidth = 40\nheight = 30\n[[object]]\nmesh = \"cube\"\n";

void expect_refused(const TemporaryFolder& folder, const std::string& line, const std::string& error) {
    const Names before = folder.names();
    const Outcome outcome = shell(folder, line);
    EXPECT_EQ(outcome.status, 2) << line;
    EXPECT_EQ(outcome.err, error + "\n") << line;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_EQ(folder.names(), before) << line;
}

TEST(Render, WritesThePictureUnderTheSceneNameOrTheGivenOne) {
    const TemporaryFolder folder;
    folder.write("box.toml", small);
    const Outcome outcome = run(folder, "render box.toml");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_EQ(run(folder, "render box.toml --output=other.png").status, 0);
    EXPECT_EQ(run(folder, "render -o third.png box.toml").status, 0);
    EXPECT_EQ(folder.names(), (Names{"box.png", "box.toml", "other.png", "third.png"}));
    EXPECT_EQ(io::bytes_of(folder.path("box.png")), io::bytes_of(folder.path("other.png")));
    const auto picture = io::read_picture(folder.path("box.png"));
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 40);
    EXPECT_EQ(picture->height, 30);
    EXPECT_GT(std::count_if(picture->pixels.begin(), picture->pixels.end(), [](int c) { return c > 120; }),
              100);
}

TEST(Render, SizeAndSetChangeThePicture) {
    const TemporaryFolder folder;
    folder.write("s.toml", small);
    ASSERT_EQ(run(folder, "render s.toml -o a.png --size 20x10 --set shading=flat --set cull=front").status,
              0);
    ASSERT_EQ(run(folder, "render s.toml -o b.png --size 20x10").status, 0);
    EXPECT_EQ(io::read_picture(folder.path("a.png"))->width, 20);
    EXPECT_NE(io::bytes_of(folder.path("a.png")), io::bytes_of(folder.path("b.png")));
}

TEST(Render, SmallestAndWidestPictures) {
    const TemporaryFolder folder;
    folder.write("s.toml", small);
    for (const std::string size : {"1x1", "8192x1", "1x8192"}) {
        EXPECT_EQ(run(folder, "render s.toml -o " + size + ".png --size " + size).status, 0) << size;
        EXPECT_TRUE(io::read_picture(folder.path(size + ".png"))) << size;
    }
}

TEST(Render, RawDepthIsTheDepthBuffer) {
    const TemporaryFolder folder;
    folder.write("s.toml", small);
    const Outcome outcome = run(folder, "render s.toml --raw-depth depth.exr");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto depth = io::read_exr(folder.path("depth.exr"));
    ASSERT_TRUE(depth);
    EXPECT_EQ(depth->width(), 40);
    EXPECT_EQ(depth->at(0, 0), 0);  // nothing there: reversed depth is cleared to 0
    EXPECT_GT(depth->at(20, 15), 0);
}

TEST(Render, StatisticsAsTextAndAsJson) {
    const TemporaryFolder folder;
    folder.write("s.toml", small);
    const Outcome text = run(folder, "render --stats s.toml");
    EXPECT_EQ(text.status, 0);
    EXPECT_NE(text.out.find("          12  triangles in the scene\n"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("milliseconds to draw it"), std::string::npos);
    const Outcome json = run(folder, "render --stats=json s.toml");
    EXPECT_EQ(json.status, 0);
    EXPECT_EQ(json.out.substr(0, 43), "{\"counts\": {\"triangles\": 12, \"vertices\": 24") << json.out;
    EXPECT_NE(json.out.find("\"milliseconds\": {\"load\": "), std::string::npos);
    expect_refused(folder, "relevo render --stats=jsn s.toml",
                   "--stats=jsn: accepted: json, text, did you mean 'json'?");
}

TEST(Render, RefusesBadNumbersOfThreads) {
    const TemporaryFolder folder;
    folder.write("s.toml", small);
    for (const std::string threads : {"0", "257", "-1", "two", "2.5", "1e9", "99999999999999999999"})
        EXPECT_EQ(run(folder, "render s.toml --threads=" + threads).err.substr(0, 41 + threads.size()),
                  "--threads " + threads + ": accepted: a whole number from");
    const Outcome outcome = run(folder, "render s.toml --threads 0");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err.substr(0, outcome.err.find("here ") + 5),
              "--threads 0: accepted: a whole number from 1 to 256 (default: the number of cores, here ");
    EXPECT_EQ(folder.names(), (Names{"s.toml"}));
}

const bool fast_is_possible = !raster::fast::instruction_sets().empty();

// Both paths, any number of threads: the same file.
TEST(Render, EveryPathDrawsTheSamePicture) {
    const TemporaryFolder folder;
    folder.write("s.toml", small);
    std::vector<std::string> ways{"--set path=textbook", "--set path=auto"};
    if (fast_is_possible)
        ways.insert(ways.end(), {"--set path=fast --threads 1", "--set path=fast --threads 2",
                                 "--threads 256", "--set path=fast --set instruction_set=sse4"});
    for (const std::string& way : ways) {
        const Outcome outcome = run(folder, "render s.toml -o way.png " + way);
        EXPECT_EQ(outcome.status, 0) << way;
        EXPECT_EQ(outcome.out + outcome.err, "") << way;
        run(folder, "render s.toml");
        EXPECT_EQ(io::bytes_of(folder.path("way.png")), io::bytes_of(folder.path("s.png"))) << way;
    }
}

TEST(Render, StatisticsSayWhichPathAndWhy) {
    const TemporaryFolder folder;
    folder.write("s.toml", small);
    const auto text = [&](const std::string& way) { return run(folder, "render s.toml --stats " + way).out; };
    const auto json = [&](const std::string& way) {
        const std::string out = run(folder, "render s.toml --stats=json " + way).out;
        const std::size_t begin = out.find("\"path\": ");
        return out.substr(begin, out.find('}', begin) + 1 - begin);
    };
    EXPECT_NE(text("--set path=textbook").find("\n        path  textbook: asked for\n"), std::string::npos);
    EXPECT_EQ(json("--set path=textbook"),
              "\"path\": {\"name\": \"textbook\", \"reason\": \"textbook: asked for\"}");
    if (!fast_is_possible) {
        const Outcome outcome = run(folder, "render s.toml --set path=fast");
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(outcome.err.substr(0, 78),
                  "warning: s.toml: pipeline.path is \"fast\", which is impossible here (textbook: ");
        return;
    }
    const std::string by_sse4 = text("--threads 3 --set instruction_set=sse4");
    EXPECT_NE(by_sse4.find("\n        path  fast: SSE4, 3 threads, tiles of 128 pixels\n"), std::string::npos)
        << by_sse4;
    EXPECT_NE(text("--threads 1 --set instruction_set=sse4").find(" fast: SSE4, 1 thread, tiles"),
              std::string::npos);
    // The cube is convex: what the textbook path shades is what is seen.
    const std::string counts = run(folder, "render s.toml --stats=json").out;
    const std::size_t begin = counts.find("\"shaded\": ") + 10;
    const std::string shaded = counts.substr(begin, counts.find('}', begin) - begin);
    EXPECT_EQ(json("--threads 3 --set instruction_set=sse4 --set path=fast"),
              "\"path\": {\"name\": \"fast\", \"reason\": \"fast: SSE4, 3 threads, tiles of 128 pixels\", "
              "\"instruction_set\": \"SSE4\", \"threads\": 3, \"tile\": 128, \"shaded\": " +
                  shaded + "}");
    EXPECT_NE(by_sse4.find(shaded + "  pixels shaded by the fast path, each of them once\n"),
              std::string::npos)
        << by_sse4;
}

TEST(Render, RefusesBadSizes) {
    const TemporaryFolder folder;
    folder.write("s.toml", small);
    for (const std::string size :
         {"0x0", "1e9x1e9", "1000000000x1000000000", "8193x8193", "-5x5", "5", "axb"})
        expect_refused(folder, "relevo render s.toml --size=" + size,
                       "--size " + size + ": accepted: WIDTHxHEIGHT, two whole numbers from 1 to 8192");
}

TEST(Render, RefusesBadSettings) {
    const TemporaryFolder folder;
    folder.write("s.toml", small);
    expect_refused(
        folder, "relevo render s.toml --set shading=phog",
        "--set shading=phog: pipeline.shading is \"phog\", accepted: unlit, flat, gouraud, phong, did you "
        "mean 'phong'?");
    expect_refused(
        folder, "relevo render s.toml --set cul=none",
        "--set cul=none: unknown key pipeline.cul, accepted: shading, texture_filter, depth, cull, path, "
        "instruction_set, did you mean 'cull'?");
}

TEST(Render, RefusesBadScenes) {
    const TemporaryFolder folder;
    const auto with = [&](const std::string& more, const std::string& error) {
        folder.write("s.toml", small + more);
        expect_refused(folder, "relevo render s.toml", error);
    };
    with("[camera]\nnear = 0\n", "s.toml:7:8: camera.near is 0, accepted: more than 0 (finite)");
    with("[camera]\nnear = 3\nfar = 2\n",
         "s.toml:7:8: camera.near is 3, accepted: less than camera.far, which is 2");
    with("[camera]\nfov_y = 0\n",
         "s.toml:7:9: camera.fov_y is 0, accepted: more than 0 and less than 180 degrees");
    with("[camera]\nfov_y = 180\n",
         "s.toml:7:9: camera.fov_y is 180, accepted: more than 0 and less than 180 degrees");
    with("[camera]\neye = [0, 3, 0]\ntarget = [0, 0, 0]\n",
         "s.toml:7:7: camera: up is parallel to the line of sight from eye to target; choose another up");
    with("material = { texture = \"none.png\" }\n",
         "s.toml:6:24: object.material.texture: none.png: there is no such file");
    with("[[object]]\nmesh = \"none.obj\"\n", "s.toml:7:8: object.mesh: none.obj: there is no such file");
    with("[[object]]\nmesh = \"none.solid\"\n", "s.toml:7:8: object.mesh: none.solid: there is no such file");
    with("[= 3]\n", "s.toml:6:2: this is not TOML: unexpected here");
    expect_refused(folder, "relevo render nowhere.toml", "nowhere.toml: there is no such file");
}

TEST(Render, LegalGeometryThatIsHardIsDrawnAndCounted) {
    const TemporaryFolder folder;
    folder.write("inside.toml", std::string(small) +
                                    "transform = [{ scale = 50 }]\n[camera]\neye = [0, 0, 0]\ntarget = "
                                    "[1, 0, 0]\n[pipeline]\ncull = \"none\"\n");
    const Outcome inside = run(folder, "render inside.toml --stats=json");
    EXPECT_EQ(inside.status, 0) << inside.err;
    EXPECT_NE(inside.out.find("\"covered\": 1200,"), std::string::npos) << inside.out;  // walls all around
    folder.write("huge.toml", std::string(small) + "transform = [{ scale = 1e30 }, { scale = 1e30 }]\n");
    const Outcome huge = run(folder, "render huge.toml --stats=json");
    EXPECT_EQ(huge.status, 0) << huge.err;
    EXPECT_NE(huge.out.find("\"rejected_non_finite\": 12,"), std::string::npos) << huge.out;
    folder.write("needle.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1e-30 0\nf 1 2 3\nf 1 2 4\n");
    folder.write("needle.toml",
                 "[camera]\neye = [1, 0, 3]\ntarget = [1, 0, 0]\n[[object]]\nmesh = \"needle.obj\"\n");
    const Outcome needle = run(folder, "render needle.toml --stats=json");
    EXPECT_EQ(needle.status, 0) << needle.err;
    EXPECT_NE(needle.out.find("\"rejected_zero_area\": 2,"), std::string::npos) << needle.out;
}

TEST(Render, AnOutputThatCannotBeWrittenLeavesTheOldFile) {
    const TemporaryFolder folder;
    folder.write("s.toml", small);
    expect_refused(folder, "relevo render s.toml -o missing/x.png",
                   "missing/x.png: cannot be written: No such file or directory");
    folder.write("old.png", "the old bytes");
    const Outcome full = shell(folder, "ulimit -f 1; relevo render s.toml --size 900x900 -o old.png");
    EXPECT_EQ(full.status, 2);
    EXPECT_EQ(full.err, "old.png: cannot be written: File too large\n");
    EXPECT_EQ(io::bytes_of(folder.path("old.png")), "the old bytes");
    EXPECT_EQ(folder.names(), (Names{"old.png", "s.toml"}));
    const Outcome device = run(folder, "render s.toml -o /dev/full");
    EXPECT_EQ(device.status, 2);
    EXPECT_EQ(device.err, "/dev/full: cannot be written: No space left on device\n");
}

TEST(Render, EverySampleSceneIsDrawn) {
    const TemporaryFolder folder;
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(RELEVO_SOURCE_DIR "/samples/scenes")) {
        if (entry.path().extension() != ".toml") continue;
        ++scenes;
        const std::string name = entry.path().stem().string();
        const Outcome outcome = run(
            folder, "render '" + entry.path().string() + "' -o " + name + ".png --size 96x72 --stats=json");
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "") << name << ": no warning";
        EXPECT_EQ(outcome.out.find("\"covered\": 0,"), std::string::npos) << name;
    }
    EXPECT_GE(scenes, 9);
}

}  // namespace
}  // namespace relevo::command
