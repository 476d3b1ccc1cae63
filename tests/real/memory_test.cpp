// What the command line needs: memory as the kernel counted it at its peak.
//   memory_test RELEVO FOLDER_OF_SCENES
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include "samples/scene/scene.hpp"

namespace relevo::real {
namespace {

std::string program, scenes;

constexpr double mebi = 1024 * 1024;

// Runs the program with its standard output thrown away; its peak memory in bytes.
double peak_of(std::vector<std::string> words) {
    words.insert(words.begin(), program);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        if (!freopen("/dev/null", "w", stdout)) _exit(126);
        execv(program.c_str(), arguments.data());
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    EXPECT_EQ(wait4(child, &status, 0, &usage), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << words[1];
    std::printf("%s %s: %.1f MiB\n", words[1].c_str(), words.back().c_str(),
                double(usage.ru_maxrss) * 1024 / mebi);
    return double(usage.ru_maxrss) * 1024;
}

double bytes_of(const scene::LoadedScene& scene) {
    double sum = 0;
    for (const auto& mesh : scene.meshes)
        sum += double(mesh->vertices.size() * sizeof(pipeline::Vertex) +
                      mesh->indices.size() * sizeof(mesh->indices[0]));
    return sum;
}

TEST(Memory, VersionNeedsTwentyMebibytes) { EXPECT_LE(peak_of({"--version"}), 20 * mebi); }

TEST(Memory, APictureNeedsItsSceneAndThreeTimesItsPixels) {
    const std::string torus = scenes + "/torus.toml";
    const auto scene = scene::load_scene(torus);
    ASSERT_TRUE(scene) << scene.error().text();
    ASSERT_GT((*scene).scene.models[0].mesh->triangles(), 99000u);
    const double picture = 1920.0 * 1080 * (4 + sizeof(pipeline::Scalar));
    const double allowed = 24 * mebi + bytes_of(*scene) + 3 * picture;
    const std::string out = testing::TempDir() + "memory_test.png";
    for (const char* shading : {"flat", "gouraud", "phong"})
        EXPECT_LE(peak_of({"render", torus, "-o", out, "--size", "1920x1080", "--set",
                           std::string("shading=") + shading}),
                  allowed);
    unlink(out.c_str());
    std::printf("allowed: %.1f MiB\n", allowed / mebi);
}

// The measure itself: an array of 64 MiB is seen.
TEST(Memory, ThePeakIsSeen) {
    const pid_t child = fork();
    if (child == 0) {
        std::vector<char> large(std::size_t(64 * mebi), 1);
        _exit(large[large.size() / 2] == 1 ? 0 : 1);
    }
    int status = 0;
    rusage usage{};
    ASSERT_EQ(wait4(child, &status, 0, &usage), child);
    EXPECT_GE(double(usage.ru_maxrss) * 1024, 64 * mebi);
}

}  // namespace
}  // namespace relevo::real

int main(int count, char** words) {
    testing::InitGoogleTest(&count, words);
    if (count != 3) return 2;
    relevo::real::program = words[1], relevo::real::scenes = words[2];
    return RUN_ALL_TESTS();
}
