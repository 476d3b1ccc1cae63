// Everything that has a golden: the stages of the machine (stages.hpp) and the inspection points of relief
// textures (relief/points.hpp), seen alike by the test and by the program that accepts.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/golden/product.hpp"

namespace relevo::golden {

struct Exhibit {
    std::string name;                                                  // folder/file below tests/golden
    std::function<Product()> product;                                  // what the library makes of it today
    std::function<std::optional<Product>(std::string_view)> mistaken;  // none: no mistake has this name
    std::function<std::optional<Product>()> plain;  // by the plain form, where there is one
    // What is wrong with `actual`; nothing when it is as it must be. The first is for two products of one
    // build, the second for the one that is kept (in float) and what any build makes.
    using Compare = std::function<std::optional<std::string>(const Product& expected, const Product& actual)>;
    Compare noticed, difference;
};
const std::vector<Exhibit>& all_exhibits();
const Exhibit* find_exhibit(std::string_view name);

struct MistakeName {
    std::string_view name, sentence;
};
std::vector<MistakeName> all_mistake_names();

}  // namespace relevo::golden
