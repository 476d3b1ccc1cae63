#include "samples/show/lessons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace relevo::show {

std::vector<Lesson> lessons(const scene::LoadedScene& loaded) {
    std::vector<Lesson> all;
    for (std::size_t shape = 0; shape < loaded.shapes.shapes.size(); ++shape)
        for (const auto family :
             {clipping_lessons, line_lessons, curve_lessons, area_lessons, antialiasing_lessons})
            std::ranges::move(family(loaded, shape), std::back_inserter(all));
    // A shape outside of the picture has nothing to show.
    std::erase_if(all, [](const Lesson& lesson) { return lesson.frames.empty() || lesson.view.empty(); });
    for (std::size_t i = 0; i < all.size(); ++i) all[i].name = fmt::format("{:02}-{}", i + 1, all[i].name);
    return all;
}

}  // namespace relevo::show
