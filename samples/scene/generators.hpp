// The generated shapes by the names and parameters that a scene uses.
#pragma once
#include "pipeline/mesh.hpp"
#include "samples/scene/fields.hpp"

namespace relevo::scene {

struct Generator {
    std::string_view name;
    std::span<const std::string_view> parameters;  // keys of [[object]] that this shape takes
    std::string_view sentence;
};

// In the order in which they are listed.
std::span<const Generator> generators();
const Generator* find_generator(std::string_view name);

// The shape with the parameters of an [[object]] table; what is wrong there is said at the key.
pipeline::Mesh generate(const Generator& generator, const Fields& object);

}  // namespace relevo::scene
