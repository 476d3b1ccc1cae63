// Everything behind `relevo steps`: a picture of every stage of a scene, strip.png with all of them small,
// and steps.json, timing.json and index.html. A two-dimensional scene has lessons in place of stages:
// lesson_files.hpp.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "samples/io/place.hpp"
#include "samples/scene/scene.hpp"

namespace relevo::show {

// The step pictures show the rendered pixels in their own size, so they have a limit of their own.
inline constexpr int max_steps_size = 2048;

struct StepsOptions {
    std::string directory;            // made when it is missing
    std::vector<std::string> stages;  // names; empty: all. They are drawn in the pipeline's order, each once
};

// Of --stage: "there is no stage 'gourad', did you mean 'gouraud'? (stages: ...)".
io::FileError unknown_name(std::string_view kind, const std::string& name,
                           std::span<const std::string_view> known);

// Refuses a picture above max_steps_size.
io::Failure too_large_for_steps(const scene::LoadedScene& loaded);

// Writes NN-stage.png for each stage, strip.png and the three lists. All files appear at the end, or none:
// when something fails, nothing is left behind, and a folder that was made is removed. The same scene gives
// the same bytes, except for timing.json. Errors: an unknown stage, a picture above max_steps_size, a folder
// or file that cannot be written.
io::Failure write_steps(const scene::LoadedScene& loaded, const StepsOptions& options);

}  // namespace relevo::show
