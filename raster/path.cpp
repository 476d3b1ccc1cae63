#include "raster/path.hpp"

#include <algorithm>

#include "raster/draw.hpp"

namespace relevo::raster {
namespace {

// Why the fast path cannot draw this; empty when it can.
std::string obstacle(const Scene& scene, const Settings& settings) {
    const auto sets = fast::instruction_sets();
    if (sizeof(pipeline::Scalar) != sizeof(float)) return "this build computes in double";
    if (sets.empty()) return "this processor has none of SSE4, AVX2, AVX-512";
    if (settings.instruction_set &&
        std::find(sets.begin(), sets.end(), *settings.instruction_set) == sets.end())
        return "this processor lacks " + std::string(fast::name(*settings.instruction_set));
    std::size_t triangles = 0;
    for (const Model& model : scene.models) triangles += model.mesh->triangles();
    if (triangles >= fast::max_triangles) return std::to_string(fast::max_triangles) + " triangles or more";
    return "";
}

// More threads get smaller tiles: more pieces to share out, and less memory each.
constexpr int most_for_large_tiles = 8;

}  // namespace

PathPlan plan_path(const Scene& scene, const Settings& settings, int threads) {
    const std::string why_not = settings.path == Path::Textbook ? "asked for" : obstacle(scene, settings);
    if (!why_not.empty()) return {.reason = "textbook: " + why_not};
    PathPlan plan{true, settings.instruction_set.value_or(fast::instruction_sets().back()), threads,
                  threads > most_for_large_tiles ? 64 : fast::Options{}.tile, ""};
    plan.reason = "fast: " + std::string(fast::name(plan.instruction_set)) + ", " + std::to_string(threads) +
                  (threads == 1 ? " thread" : " threads") + ", tiles of " + std::to_string(plan.tile) +
                  " pixels";
    return plan;
}

Rendering render(const Scene& scene, const Settings& settings, Frame& frame, fast::Workspace& workspace,
                 fast::Workers* workers) {
    Rendering out{plan_path(scene, settings, workers ? workers->count() : 1), {}};
    if (out.plan.fast)
        out.counts = fast::draw(scene, settings, frame, workspace,
                                {out.plan.instruction_set, out.plan.tile, workers, nullptr});
    else
        draw(scene, settings, frame);
    return out;
}

}  // namespace relevo::raster
