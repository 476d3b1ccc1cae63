// The fast path gives the textbook path's bytes: colour, depth, linear colour, visible primitives and counts,
// for every instruction set, number of threads and tile size of this machine. scripts/identity asks for more.
#include <gtest/gtest.h>

#include <random>

#include "pipeline/projection.hpp"
#include "samples/scene/scene.hpp"
#include "tests/raster/fast/identity_scenes.hpp"

namespace relevo::tests::identity {
namespace {

TEST(Identity, ThereIsAFastPath) {
    EXPECT_FALSE(fast::instruction_sets().empty());
    EXPECT_EQ(all_ways().size(), 9 * fast::instruction_sets().size());
}

TEST(Identity, PairsMeetInFewRows) {
    const std::vector<int> choices{4, 3, 2, 6};
    const auto rows = pairs(choices);
    EXPECT_LT(rows.size(), 36u);
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = a + 1; b < 4; ++b) {
            std::vector<std::pair<int, int>> met;
            for (const auto& row : rows) met.emplace_back(row[a], row[b]);
            std::sort(met.begin(), met.end());
            EXPECT_EQ(std::unique(met.begin(), met.end()) - met.begin(), choices[a] * choices[b]);
        }
    EXPECT_EQ(product(choices).size(), 144u);
}

// ------------------------------------------------------------------------------------------- every feature
std::string shading_name(const testing::TestParamInfo<raster::Shading>& shading) {
    constexpr const char* names[] = {"Unlit", "Flat", "Gouraud", "Phong"};
    return names[static_cast<int>(shading.param)];
}
class EveryFeature : public testing::TestWithParam<raster::Shading> {};

TEST_P(EveryFeature, WithEveryOther) {
    const Subject subject = everything();
    std::uint64_t drawn = 0;
    std::size_t number = 0;
    for (const auto& choice : product(feature_choices)) {
        const Features f = features(choice);
        if (f.shading != GetParam()) continue;
        const Size size{61, 47};
        ASSERT_EQ(first_difference(dressed(subject, f, size), settings(f), size, few_ways(number++), &drawn),
                  "")
            << text(f);
    }
    EXPECT_GT(drawn, 500 * number);
}

INSTANTIATE_TEST_SUITE_P(Identity, EveryFeature,
                         testing::Values(raster::Shading::Unlit, raster::Shading::Flat,
                                         raster::Shading::Gouraud, raster::Shading::Phong),
                         shading_name);

TEST(Identity, EveryWayOnEverySize) {
    const Subject subject = everything();
    for (const auto& choice : pairs(feature_choices)) {
        const Features f = features(choice);
        for (const Size size : odd_sizes)
            ASSERT_EQ(first_difference(dressed(subject, f, size), settings(f), size, all_ways()), "")
                << text(f);
    }
}

// ------------------------------------------------------------------------------------------ every subject
// Every two features, and every feature with every size and way.
void expect_pairs_same(const Subject& subject, const std::vector<Size>& sizes) {
    std::vector<int> choices = feature_choices;
    choices.push_back(static_cast<int>(sizes.size()));
    std::uint64_t drawn = 0;
    std::size_t number = 0;
    for (const auto& choice : pairs(choices)) {
        const Features f = features(choice);
        const Size size = sizes[std::size_t(choice.back())];
        ASSERT_EQ(first_difference(dressed(subject, f, size), settings(f), size, few_ways(number++), &drawn),
                  "")
            << subject.name << ", " << text(f);
    }
    EXPECT_GT(drawn, 1000u);
}

const std::vector<Size> every_odd_size(std::begin(odd_sizes), std::end(odd_sizes));

TEST(Identity, Torus1k) { expect_pairs_same(torus("torus_1k", 25, 20), every_odd_size); }
TEST(Identity, Fill) { expect_pairs_same(fill(), every_odd_size); }
TEST(Identity, InsideATorus) { expect_pairs_same(inside_torus(40, 30), every_odd_size); }
TEST(Identity, Bunny) { expect_pairs_same(bunny(), {{127, 129}}); }
TEST(Identity, InsideTheBunny) { expect_pairs_same(inside_bunny(), {{127, 129}}); }
TEST(Identity, Torus100k) {
    const Subject subject = torus("torus_100k", 250, 200);
    std::size_t number = 0;
    for (const raster::Shading shading :
         {raster::Shading::Flat, raster::Shading::Gouraud, raster::Shading::Phong}) {
        Features f;
        f.shading = shading, f.texturing = Texturing::Bilinear;
        const Size size{333, 211};
        EXPECT_EQ(first_difference(dressed(subject, f, size), settings(f), size, few_ways(number++)), "");
    }
}
TEST(Identity, Torus1m) {
    const Subject subject = torus("torus_1m", 1000, 500);
    Features f;
    f.cull = pipeline::Cull::Back;
    const Size size{641, 479};
    EXPECT_EQ(first_difference(dressed(subject, f, size), settings(f), size, few_ways(1)), "");
}

// ------------------------------------------------------------------------------------------- sample scenes
class SampleScene : public testing::TestWithParam<std::string> {};

TEST_P(SampleScene, IsTheSame) {
    const std::string path = std::string(RELEVO_SCENES) + "/" + GetParam() + ".toml";
    std::uint64_t drawn = 0;
    std::size_t number = 0;
    for (const char* depth : {"depth=float32-reversed", "depth=float32-forward"}) {
        auto loaded = scene::load_scene(path, {{depth}, {}});
        ASSERT_TRUE(loaded) << loaded.error().text();
        for (const auto& choice : pairs({4, 2, 2, 3, std::size(odd_sizes)})) {
            raster::Settings& s = loaded->settings;
            s.shading = static_cast<raster::Shading>(choice[0]);
            s.texture_filter = static_cast<raster::Filter>(choice[1]);
            s.output = static_cast<raster::Output>(choice[2]);
            s.cull = static_cast<pipeline::Cull>(choice[3]);
            const Size size = odd_sizes[std::size_t(choice[4])];
            ASSERT_EQ(first_difference(loaded->scene, s, size, few_ways(number++), &drawn), "")
                << depth << ", shading " << choice[0] << ", filter " << choice[1] << ", output " << choice[2]
                << ", cull " << choice[3];
        }
    }
    EXPECT_GT(drawn, 50000u);
}

INSTANTIATE_TEST_SUITE_P(Identity, SampleScene, testing::ValuesIn(sample_scenes()),
                         [](const testing::TestParamInfo<std::string>& name) { return name.param; });

// -------------------------------------------------------------------------------------- what changes nothing
TEST(Identity, FirstCornerAndWindingLeaveEveryBit) {
    constexpr int orders[][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const Size size{127, 129};
    for (const Subject& subject : {everything(), torus("torus_1k", 25, 20), inside_torus(12, 9)})
        for (int shading = 0; shading < 4; ++shading) {
            Features f;
            f.shading = static_cast<raster::Shading>(shading), f.texturing = Texturing::Bilinear;
            f.two_sided = f.shading == raster::Shading::Flat;  // its normal turns with the winding
            for (const Way& way : few_ways(0)) {
                std::vector<Answer> answers;
                for (const auto& order : orders) {
                    Subject turned{subject.name, {}, {}};
                    turned.scene.camera = subject.scene.camera;
                    turned.near = subject.near, turned.half_height = subject.half_height;
                    for (const raster::Model& model : subject.scene.models) {
                        pipeline::Mesh mesh = *model.mesh;
                        for (std::size_t t = 0; t < mesh.triangles(); ++t)
                            for (std::size_t k = 0; k < 3; ++k)
                                mesh.indices[3 * t + k] = model.mesh->indices[3 * t + std::size_t(order[k])];
                        turned.add(std::move(mesh), model.world_from_object);
                    }
                    answers.push_back(fast_path(dressed(turned, f, size), settings(f), size, way));
                    ASSERT_EQ(difference(answers[0], answers.back()), "")
                        << subject.name << ", " << text(f) << ", " << text(way) << ", corners " << order[0]
                        << order[1] << order[2];
                }
                EXPECT_GT(answers[0].counts.shaded_pixels, 1000u);
            }
        }
}

TEST(Identity, EachVisiblePixelIsShadedOnce) {
    const Size size{200, 150};
    const Features f;
    for (const Subject& subject : {fill(), everything(), torus("torus_1k", 25, 20)}) {
        const raster::Scene scene = dressed(subject, f, size);
        Watch watch(size.width, size.height);  // the textbook shades whatever passes the depth test
        std::uint64_t shaded = 0;
        watch.on_shaded = [&](const raster::FragmentShaded&) { ++shaded; };
        raster::Frame frame = frame_of(size.width, size.height);
        draw_watched(scene, settings(f), frame, watch);
        for (const Way& way : all_ways()) {
            const Answer answer = fast_path(scene, settings(f), size, way);
            std::uint64_t visible = 0;
            for (const pipeline::Scalar z : answer.frame.depth.pixels()) visible += z != 0;
            EXPECT_EQ(answer.counts.shaded_pixels, visible) << text(way);
            EXPECT_LT(visible, shaded) << "there is overdraw";
        }
    }
}

// ------------------------------------------------------------------------------------------------- workspace
struct Job {
    Subject subject;
    Features features;
    Size size;
};
std::vector<Job> jobs() {
    Features flat, textured;
    flat.shading = raster::Shading::Flat, flat.two_sided = true;
    textured.texturing = Texturing::Bilinear, textured.depth = raster::DepthFormat::Float32Forward;
    return {{everything(), {}, {61, 47}},        {torus("torus_20k", 100, 100), textured, {300, 200}},
            {everything(), flat, {1, 1}},        {fill(), textured, {641, 479}},
            {{"nothing", {}, {}}, {}, {64, 64}}, {inside_torus(12, 9), textured, {33, 65}}};
}

TEST(Workspace, KeepsNothingThatCanBeSeen) {
    const std::vector<Job> all = jobs();
    std::vector<Answer> right;
    for (const Job& job : all)
        right.push_back(
            textbook(dressed(job.subject, job.features, job.size), settings(job.features), job.size));
    const auto draw_all = [&](const Way& way, fast::Workspace& workspace) {
        for (const std::size_t i : {0, 1, 2, 1, 0, 3, 4, 3, 5, 1, 5}) {
            const Job& job = all[i];
            const Answer got = fast_path(dressed(job.subject, job.features, job.size), settings(job.features),
                                         job.size, way, workspace);
            ASSERT_EQ(difference(right[i], got), "") << job.subject.name << ", " << text(way);
        }
    };
    fast::Workspace shared;
    for (const Way& way : all_ways()) draw_all(way, shared);
    for (const Way& way : few_ways(0)) {
        fast::Workspace fresh;
        draw_all(way, fresh);
        fast::Workspace moved = std::move(fresh);
        draw_all(way, moved);
        fresh = fast::Workspace();
        draw_all(way, fresh);
    }
}

TEST(Workspace, MemoryIsBounded) {
    constexpr std::uint64_t mebi = 1024 * 1024;
    const auto expect_bounded = [](const Subject& subject, Size size) {
        Features f;
        f.texturing = Texturing::Bilinear;  // the most that a corner can carry
        for (const Way& way : all_ways()) {
            if (way.threads == 2) continue;
            fast::Workspace workspace;
            const fast::Counts counts =
                fast_path(dressed(subject, f, size), settings(f), size, way, workspace).counts;
            EXPECT_LE(workspace.bytes(), counts.vertices * 48 + counts.triangles * 8 + 64 * mebi)
                << subject.name << ", " << text(way);
            EXPECT_GT(workspace.bytes(), 0u);
        }
    };
    expect_bounded(torus("torus_1m", 1000, 500), {641, 479});
    expect_bounded(everything(), {8192, 256});
}

// Every triangle crosses the near plane and is clipped to two: far more pieces than are kept.
TEST(Workspace, MemoryIsBoundedWhateverIsClipped) {
    constexpr std::uint32_t triangles = 250'000;
    pipeline::Mesh mesh;
    std::mt19937 random(5);
    const auto place = [&] { return static_cast<float>(random() % 2001) / 1000 - 1; };
    for (std::uint32_t t = 0; t < triangles; ++t)
        for (int corner = 0; corner < 3; ++corner) {
            const float z = corner < 2 ? -1 - place() : 4 + place();  // the eye stands at z = 2
            mesh.vertices.push_back({{{place(), place(), z}}, {{0, 0, 1}}, {place(), place()}});
            mesh.indices.push_back(3 * t + static_cast<std::uint32_t>(corner));
        }
    raster::Scene scene;
    scene.models.push_back({&mesh, {}, {}, nullptr, true});
    scene.camera = {*pipeline::look_at({0, 0, 2}, {0, 0, 0}, {0, 1, 0}),
                    *pipeline::perspective({60}, 1.3, 0.1, 10, pipeline::DepthRange::Reversed), false};
    scene.lights = {{}};
    raster::Settings settings;
    settings.shading = raster::Shading::Gouraud, settings.cull = pipeline::Cull::None;
    const Size size{61, 47};
    const Answer right = textbook(scene, settings, size);
    EXPECT_GT(right.counts.clipped, triangles / 2);
    for (const fast::InstructionSet set : fast::instruction_sets()) {
        fast::Workspace workspace;
        const Way way{set, set == fast::InstructionSet::Avx2 ? 2 : 1, 64};
        EXPECT_EQ(difference(right, fast_path(scene, settings, size, way, workspace)), "") << text(way);
        EXPECT_LE(workspace.bytes(), mesh.vertices.size() * 48 + triangles * 8 + (std::size_t{64} << 20));
    }
}

}  // namespace
}  // namespace relevo::tests::identity
