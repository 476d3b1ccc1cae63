// Which way through the machine a picture takes: the textbook's (raster/draw.hpp) or the fast one
// (raster/fast/draw_fast.hpp). Both give the same bytes.
#pragma once
#include <string>

#include "raster/fast/draw_fast.hpp"

namespace relevo::raster {

struct PathPlan {
    bool fast;
    fast::InstructionSet instruction_set;  // when fast
    std::string reason;                    // one clause: why this one
};

// What settings.path asks for, if it is possible.
PathPlan plan_path(const Scene& scene, const Settings& settings);

// Draws by the path that plan_path() names; workers as in fast::Options.
PathPlan render(const Scene& scene, const Settings& settings, Frame& frame, fast::Workspace& workspace,
                fast::Workers* workers = nullptr);

}  // namespace relevo::raster
