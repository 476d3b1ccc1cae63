// Which path, and why; what render() does is what the plan says.
#include "raster/path.hpp"

#include <gtest/gtest.h>

#include "raster/draw.hpp"

namespace relevo::raster {
namespace {

using fast::InstructionSet;

const bool is_double = sizeof(pipeline::Scalar) != sizeof(float);
const std::string impossible = is_double ? "textbook: this build computes in double"
                                         : "textbook: this processor has none of SSE4, AVX2, AVX-512";

Settings asking_for(Path path, std::optional<InstructionSet> set = std::nullopt) {
    Settings settings;
    settings.path = path, settings.instruction_set = set;
    return settings;
}

TEST(Path, TheTextbooksWhenAskedFor) {
    const PathPlan plan = plan_path({}, asking_for(Path::Textbook), 7);
    EXPECT_FALSE(plan.fast);
    EXPECT_EQ(plan.threads, 1);
    EXPECT_EQ(plan.reason, "textbook: asked for");
}

TEST(Path, TheFastOneWhereverItIsPossible) {
    for (const Path path : {Path::Auto, Path::Fast}) {
        const PathPlan plan = plan_path({}, asking_for(path), 2);
        if (fast::instruction_sets().empty()) {
            EXPECT_EQ(plan.reason, impossible);
            continue;
        }
        const InstructionSet widest = fast::instruction_sets().back();
        EXPECT_TRUE(plan.fast);
        EXPECT_EQ(plan.instruction_set, widest);
        EXPECT_EQ(plan.threads, 2);
        EXPECT_EQ(plan.tile, 128);
        EXPECT_EQ(plan.reason, "fast: " + std::string(name(widest)) + ", 2 threads, tiles of 128 pixels");
    }
}

TEST(Path, SmallerTilesForManyThreads) {
    if (fast::instruction_sets().empty()) return;
    EXPECT_EQ(plan_path({}, asking_for(Path::Auto), 8).tile, 128);
    EXPECT_EQ(plan_path({}, asking_for(Path::Auto), 9).tile, 64);
}

TEST(Path, AnInstructionSetOnDemand) {
    for (const InstructionSet set : {InstructionSet::Sse4, InstructionSet::Avx2, InstructionSet::Avx512}) {
        const auto there = fast::instruction_sets();
        const bool has = std::find(there.begin(), there.end(), set) != there.end();
        const PathPlan plan = plan_path({}, asking_for(Path::Auto, set));
        EXPECT_EQ(plan.fast, has);
        EXPECT_EQ(plan.reason, has ? "fast: " + std::string(name(set)) + ", 1 thread, tiles of 128 pixels"
                               : there.empty() ? impossible
                                               : "textbook: this processor lacks " + std::string(name(set)));
    }
}

TEST(Path, TooManyTrianglesForTheFastOne) {
    pipeline::Mesh mesh;  // only counted
    mesh.indices.resize(3 * (fast::max_triangles / 64));
    Model model;
    model.mesh = &mesh;
    Scene scene;
    scene.models.assign(63, model);
    EXPECT_EQ(plan_path(scene, {}).fast, !fast::instruction_sets().empty());
    scene.models.push_back(model);
    EXPECT_FALSE(plan_path(scene, {}).fast);
    EXPECT_EQ(plan_path(scene, {}).reason,
              fast::instruction_sets().empty() ? impossible : "textbook: 67108864 triangles or more");
}

TEST(Path, RenderDoesWhatThePlanSays) {
    pipeline::Mesh mesh;
    mesh.vertices.resize(3);
    mesh.vertices[0].position = {{-1, -1, -2}};
    mesh.vertices[1].position = {{1, -1, -2}};
    mesh.vertices[2].position = {{0, 1, -2}};
    mesh.indices = {0, 1, 2};
    Model model;
    model.mesh = &mesh;
    Scene scene;
    scene.models = {model};
    scene.camera.clip_from_eye.m[2] = {0, 0, 0, -1}, scene.camera.clip_from_eye.m[3] = {0, 0, 0.1, 0};
    const auto frame = [] { return Frame{Image<Rgba8>(65, 33), Image<pipeline::Scalar>(65, 33), {}}; };
    const Settings textbook = asking_for(Path::Textbook);
    Frame right = frame();
    draw(scene, textbook, right);
    const auto seen = std::count_if(right.depth.pixels().begin(), right.depth.pixels().end(),
                                    [](pipeline::Scalar z) { return z > 0; });
    ASSERT_GT(seen, 100);
    fast::Workspace workspace;
    fast::Workers workers(2);
    for (const Path path : {Path::Auto, Path::Fast, Path::Textbook}) {
        Frame drawn = frame();
        const Rendering rendering = render(scene, asking_for(path), drawn, workspace, &workers);
        EXPECT_EQ(rendering.plan.reason, plan_path(scene, asking_for(path), 2).reason);
        EXPECT_EQ(drawn.color.pixels(), right.color.pixels());
        EXPECT_EQ(drawn.depth.pixels(), right.depth.pixels());
        EXPECT_EQ(rendering.counts.shaded_pixels, rendering.plan.fast ? std::uint64_t(seen) : 0u);
    }
}

}  // namespace
}  // namespace relevo::raster
