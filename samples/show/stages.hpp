// The stages of `relevo steps`, in the order of the pipeline.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "samples/show/stage.hpp"

namespace relevo::show {

struct StageInfo {
    std::string_view name, sentence;  // the sentence is the picture's caption
    StagePage (*draw)(const Capture&, const Heading&);
};
std::span<const StageInfo> stages();

// The picture of stages()[index].
StagePage draw_stage(const Capture& capture, std::size_t index);

// "03-eye.png"
std::string stage_file(std::size_t index);

}  // namespace relevo::show
