// Objects shown by pictures of themselves: the keys `surface`, `representation` and `relief` of [[object]].
#pragma once
#include "samples/scene/fields.hpp"

namespace relevo::scene {

struct SurfaceInfo {
    std::string_view name, sentence;
};
// The analytic surfaces that `surface` names.
std::span<const SurfaceInfo> surfaces();
relief::AnalyticSurface find_surface(const Fields& object, Diagnosis& diagnosis);

// [object.relief]; keys that the representation does not use are refused.
relief::RepresentationSettings read_relief(const Fields& object, relief::Representation representation,
                                           Diagnosis& diagnosis);

}  // namespace relevo::scene
