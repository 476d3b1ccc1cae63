// Where every triangle of a scene stands to the six planes of the view volume, and what the planes leave of
// it.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "samples/show/capture.hpp"

namespace relevo::show {

enum class Fate : std::uint8_t {
    Inside,     // all corners inside all planes
    Crossing,   // neither inside nor outside
    Outside,    // all corners beyond one plane
    NotFinite,  // a corner is infinite or not a number
};

struct PlaneCensus {
    std::string name;                         // "z = w near"
    std::array<std::int64_t, 3> triangles{};  // by Fate: inside, crossing, outside
};

struct Census {
    std::vector<std::vector<Fate>> fates;  // [model][triangle]
    std::array<std::int64_t, 4> total{};   // by Fate
    std::array<PlaneCensus, 6> planes;     // near, far, left, right, bottom, top
};
Census take_census(const Capture& capture);

// What is left of a triangle after clipping at all six planes.
struct ClippedPiece {
    std::uint32_t model;
    bool cut;                     // it crossed a plane
    std::vector<glm::dvec3> ndc;  // 3..9 corners
    std::vector<bool> made;       // whether a plane made the corner
};
std::vector<ClippedPiece> clip_to_view_volume(const Capture& capture, const Census& census);

}  // namespace relevo::show
