// The step pictures of reliefs: each is there, tells its numbers, and says so when it has nothing to show.
#include "samples/show/relief_stages.hpp"

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "samples/scene/draw_scene.hpp"
#include "samples/show/steps.hpp"
#include "tests/samples/io/temporary_folder.hpp"
#include "tests/samples/show/scenes.hpp"

namespace relevo::show {
namespace {

using io::TemporaryFolder;

const std::string head = R"([image]
width = 64
height = 48
[camera]
eye = [0.9, 0.5, 2.9]
target = [0, 0, 0]
fov_y = 45
near = 0.5
)";
const std::string bumpy = R"([[object]]
surface = "bumpy"
representation = "relief"
[object.relief]
radius = 1
texels = 64
)";
const std::string ground = R"([[object]]
mesh = "plane"
transform = [ { scale = 3 }, { translate = [0, -0.3, 0] } ]
)";

Heading heading_of(const ReliefStageInfo& stage) {
    return {1, 20, std::string(stage.name), std::string(stage.sentence), "test"};
}
std::map<std::string, double> counts_of(const StagePage& page) {
    std::map<std::string, double> counts;
    for (const Count& count : page.counts)
        std::visit([&](auto value) { counts[count.name] = static_cast<double>(value); }, count.value);
    return counts;
}
std::map<std::string, double> counts_of(const ReliefView& view, std::string_view name) {
    for (const ReliefStageInfo& stage : relief_stages())
        if (stage.name == name) return counts_of(draw_stage(view, stage, heading_of(stage)));
    ADD_FAILURE() << name;
    return {};
}

TEST(ReliefStages, AreTwentyWithNamesOfTheirOwn) {
    std::map<std::string_view, int> names;
    for (const ReliefStageInfo& stage : relief_stages()) ++names[stage.name];
    EXPECT_EQ(names.size(), 20u);
    EXPECT_EQ(relief_stages().size(), 20u);
}

// Every way that an object can be shown, from surfaces and from a mesh: all stages have a page of a size
// that fits a slide, and the same scene gives the same bytes.
TEST(ReliefStages, EveryRepresentationHasAllPages) {
    for (const std::string way :
         {"relief", "relief-box", "relief-inverse", "sprite", "sprite-depth", "ldi", "morph", "geometry"})
        for (const std::string what : {"surface = \"complex\"", "mesh = \"torus\""}) {
            const bool mesh = what[0] == 'm';
            if (mesh && way == "geometry") continue;
            const std::string small = way == "geometry" ? "" : "[object.relief]\ntexels = 32\n";
            const scene::LoadedScene loaded =
                loaded_scene(head + "[[object]]\n" + what + "\nrepresentation = \"" + way + "\"\n" + small);
            const ReliefView view = relief_view(loaded), again = relief_view(loaded);
            EXPECT_EQ(view.problem, "");
            for (const ReliefStageInfo& stage : relief_stages()) {
                const StagePage page = draw_stage(view, stage, heading_of(stage));
                EXPECT_GE(page.picture.width(), 900) << stage.name;
                EXPECT_LE(page.picture.width(), 1800) << stage.name;
                EXPECT_LE(page.picture.height(), 1400) << stage.name;
                const bool picture_only = stage.name == "final" || stage.name == "relief-truth";
                EXPECT_EQ(page.counts.empty(), picture_only) << stage.name;
                if (way != "relief") continue;
                const StagePage twice = draw_stage(again, stage, heading_of(stage));
                EXPECT_EQ(page.picture.pixels(), twice.picture.pixels()) << stage.name;
            }
        }
}

TEST(ReliefStages, TheirNumbersAreThoseOfTheTechniques) {
    const scene::LoadedScene loaded = loaded_scene(head + bumpy + ground);
    const ReliefView view = relief_view(loaded);
    ASSERT_EQ(view.problem, "");

    auto source = counts_of(view, "relief-source");
    EXPECT_EQ(source["texels"], 64 * 64);
    EXPECT_NEAR(source["covered"] / (64 * 64), 0.55, 0.01);
    EXPECT_GE(source["nearest"], 0);
    EXPECT_LE(source["deepest"], 2);

    auto bits = counts_of(view, "relief-bits");
    EXPECT_LE(bits["largest_error_8_bit"], bits["step_8_bit"] / 2 * 1.001);
    EXPECT_LE(bits["largest_error_16_bit"], bits["step_16_bit"] / 2 * 1.02);

    auto order = counts_of(view, "relief-order");
    // the foot of the eye: texels of 1/32 from (-1, 1), rows downwards
    EXPECT_NEAR(order["epipole_u"], (0.9 + 1) * 32, 1e-9);
    EXPECT_NEAR(order["epipole_v"], (1 - 0.5) * 32, 1e-9);
    EXPECT_EQ(order["sheets"], 4);

    auto kinds = counts_of(view, "relief-kinds");
    std::int64_t covered = 0;
    for (const auto c : view.picture.coverage.pixels()) covered += c != 0;
    EXPECT_EQ(kinds["sampled"] + kinds["filled"] + kinds["filled_across"], double(covered));
    EXPECT_GE(kinds["paintings"], double(covered));

    auto disorder = counts_of(view, "relief-disorder");
    EXPECT_LE(disorder["wrong_in_the_right_order"] / disorder["pixels"], 0.013);
    EXPECT_GE(disorder["wrong_in_the_wrong_order"] / disorder["pixels"], 0.05);

    auto mesh = counts_of(view, "relief-mesh");
    EXPECT_GT(mesh["interleaved_psnr"], 18);

    auto error = counts_of(view, "relief-error");
    EXPECT_GT(error["relief_psnr"], error["sprite_psnr"] + 5);

    auto depth = counts_of(view, "relief-depth");
    EXPECT_LT(depth["wrong_object"], depth["wrong_object_of_the_sprite"] / 5);

    auto inverse = counts_of(view, "relief-inverse");
    EXPECT_LT(inverse["psnr_8_slices"], inverse["psnr_32_slices"]);
    EXPECT_GT(inverse["psnr_32_slices_8_halvings"], inverse["psnr_128_slices"] - 0.5);

    auto solid = counts_of(view, "relief-solid");
    EXPECT_GT(solid["without_end_extra_percent"], solid["back_extra_percent"]);

    auto faces = counts_of(view, "relief-faces");
    EXPECT_EQ(faces["faces_in_front"], 1);  // z > 1, x and y within the box
    EXPECT_EQ(faces["region"], 1 + 3 + 18);
    EXPECT_LE(faces["nearest_missing_percent"], 0.5);
}

TEST(ReliefStages, TheShadowIsNearlyTheTruth) {
    const std::string light = "[[light]]\ntype = \"directional\"\ndirection = [0.9, -0.5, -0.6]\n";
    auto shadow = counts_of(relief_view(loaded_scene(head + light + bumpy)), "relief-shadow");
    EXPECT_GT(shadow["blocked"], 10);
    EXPECT_GT(shadow["turned_away"], shadow["blocked"]);
    EXPECT_LT(shadow["wrong"], 0.06 * (shadow["lit"] + shadow["turned_away"] + shadow["blocked"]));
}

TEST(ReliefStages, ViewMorphingIsBestAndFlowFollowsNearViewsOnly) {
    const auto morph = [](const std::string& aside) {
        return counts_of(
            relief_view(loaded_scene(head + "[[object]]\nsurface = \"bumpy\"\nrepresentation = \"morph\"\n" +
                                     "[object.relief]\nradius = 1\ntexels = 64\naside = " + aside + "\n")),
            "relief-morph");
    };
    auto near = morph("2"), far = morph("20");
    EXPECT_GT(far["view_morph_psnr"], far["plain_psnr"] + 3);
    EXPECT_GT(far["view_morph_psnr"], far["view_morph_by_flow_psnr"] + 3);
    EXPECT_LT(near["flow_mean_off"], 0.1 * far["flow_mean_off"]);
    EXPECT_GT(near["flow_within_a_pixel"], 0.8 * near["flow_knows"]);
    for (auto& counts : {&near, &far}) {
        EXPECT_LE((*counts)["flow_within_a_pixel"], (*counts)["flow_knows"]);
        EXPECT_LE((*counts)["flow_knows"], (*counts)["visible_in_both"]);
    }
}

TEST(ReliefStages, TheFinalPictureIsTheRenderedOne) {
    const scene::LoadedScene loaded = loaded_scene(head + bumpy + ground);
    const ReliefView view = relief_view(loaded);
    raster::Frame frame = scene::make_frame(loaded);
    raster::fast::Workspace workspace;
    ASSERT_TRUE(draw_scene(loaded, *take_pictures(loaded), 0, frame, workspace));
    for (const ReliefStageInfo& stage : relief_stages()) {
        if (stage.name != "final") continue;
        const StagePage page = draw_stage(view, stage, heading_of(stage));
        ASSERT_EQ(page.pixels.width, loaded.width * page.factor);
        for (int y = 0; y < loaded.height; ++y)
            for (int x = 0; x < loaded.width; ++x)
                ASSERT_EQ(
                    page.picture.at(page.pixels.x + x * page.factor + 1, page.pixels.y + y * page.factor + 1),
                    frame.color.at(x, y));
    }
}

TEST(ReliefStages, WhatCannotBeShownIsSaid) {
    const std::string behind =
        "[image]\nwidth = 40\nheight = 30\n[camera]\neye = [0, 0, -3]\ntarget = [0, 0, 0]\n";
    const ReliefView view = relief_view(loaded_scene(behind + bumpy));
    EXPECT_EQ(view.problem.substr(0, 51), "No relief can be warped here: the viewer must lie i");
    const scene::LoadedScene parallel = loaded_scene(
        "[camera]\nprojection = \"orthographic\"\neye = [0, 0, 3]\ntarget = [0, 0, 0]\n" + bumpy);
    EXPECT_EQ(relief_view(parallel).problem, "These pictures need a viewer: a parallel view has no eye.");
}

// ---------------------------------------------------------------------------------------------- the folder

TEST(ReliefSteps, AReliefSceneHasItsStagesAndAMixedOneBoth) {
    for (const bool mixed : {false, true}) {
        const TemporaryFolder folder;
        const scene::LoadedScene loaded = loaded_scene(head + bumpy + (mixed ? ground : ""));
        ASSERT_FALSE(write_steps(loaded, {folder.path("steps"), {}}));
        const auto steps = nlohmann::json::parse(io::bytes_of(folder.path("steps/steps.json")));
        ASSERT_EQ(steps["stages"].size(), mixed ? 36u : 20u);
        for (const auto& stage : steps["stages"])
            EXPECT_TRUE(std::filesystem::exists(folder.path("steps/" + stage["file"].get<std::string>())));
        EXPECT_EQ(steps["stages"][mixed ? 16 : 0]["file"],
                  mixed ? "17-relief-source.png" : "01-relief-source.png");
    }
}

TEST(ReliefSteps, OneStageOrAnErrorThatNamesThemAll) {
    const TemporaryFolder folder;
    const scene::LoadedScene loaded = loaded_scene(head + bumpy);
    ASSERT_FALSE(write_steps(loaded, {folder.path("one"), {"relief-kinds"}}));
    EXPECT_TRUE(std::filesystem::exists(folder.path("one/08-relief-kinds.png")));
    const auto failure = write_steps(loaded, {folder.path("none"), {"relief-kind"}});
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->text().substr(0, 78),
              "--stage: there is no stage 'relief-kind', did you mean 'relief-kinds'? (stages");
}

}  // namespace
}  // namespace relevo::show
