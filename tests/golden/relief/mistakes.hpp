// What people get wrong in relief textures; see subject.hpp for where a mistake can be made.
#pragma once
#include <span>

#include "tests/golden/relief/subject.hpp"

namespace relevo::golden {

std::span<const ReliefMistake> all_relief_mistakes();
const ReliefMistake* find_relief_mistake(std::string_view name);

}  // namespace relevo::golden
