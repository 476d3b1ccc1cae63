// Which way through the machine a picture takes: the textbook's (raster/draw.hpp) or the fast one
// (raster/fast/draw_fast.hpp). Both give the same bytes.
//
//   settings.path   textbook    the textbook's
//                   fast, auto  the fast one; where it is impossible, the textbook's: a scene that asks for
//                               the fast path is drawn on every machine, and the plan says how and why
#pragma once
#include <string>

#include "raster/fast/draw_fast.hpp"
#include "raster/fast/workers.hpp"

namespace relevo::raster {

struct PathPlan {
    bool fast = false;
    fast::InstructionSet instruction_set{};  // these three: when fast
    int threads = 1, tile = 0;
    std::string reason;  // one clause: "fast: AVX-512, 2 threads, tiles of 128 pixels", "textbook: asked for"
};

// The path for this scene. The fast one takes settings.instruction_set, or the widest that is there, and
// `threads` threads.
PathPlan plan_path(const Scene& scene, const Settings& settings, int threads = 1);

// What render() did; `counts` when the fast path drew.
struct Rendering {
    PathPlan plan;
    fast::Counts counts;
};

// Draws by the path that plan_path() names, with draw()'s preconditions; workers as in fast::Options.
Rendering render(const Scene& scene, const Settings& settings, Frame& frame, fast::Workspace& workspace,
                 fast::Workers* workers = nullptr);

}  // namespace relevo::raster
