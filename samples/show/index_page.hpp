// The page that shows all step pictures of a scene, one file that needs no network and no scripts.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "samples/scene/scene.hpp"
#include "samples/show/stage.hpp"

namespace relevo::show {

// A step picture that has been drawn, as steps.json and the page list it.
struct StageRecord {
    int number;  // 1..
    std::string name, file, caption;
    std::vector<Count> counts;
    int width, height;  // of the file's picture
};

std::string index_page(const scene::LoadedScene& loaded, std::span<const StageRecord> records);

}  // namespace relevo::show
