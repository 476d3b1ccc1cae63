// The known mistakes: what people get wrong in a rasterizer, each as a change to a scene, to the plain
// machine's rules or to a finished picture; never to the machine itself. Every golden names those that it
// must notice, and a test makes each of them.
#pragma once
#include <span>
#include <string_view>

#include "tests/golden/product.hpp"
#include "tests/golden/stages.hpp"

namespace relevo::golden {

struct Mistake {
    std::string_view name;
    std::string_view sentence;
    void (*to_scene)(Subject&) = nullptr;
    Rules rules = {};
    void (*to_product)(Product&) = nullptr;
    bool truncates = false;
};

std::span<const Mistake> all_mistakes();
const Mistake* find_mistake(std::string_view name);

// What someone who makes this mistake gets.
Product mistaken(const Case& which, const Mistake& mistake);

}  // namespace relevo::golden
