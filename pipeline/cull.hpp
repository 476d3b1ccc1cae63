// Back-face culling, after snapping: the sign of the snapped area decides (textbook 6.1;
// Direct3D 11.3 3.4.1).
#pragma once
#include <cstdint>

namespace relevo::pipeline {

enum class Cull { None, Back, Front };
enum class Facing { Front, Back };

// `area2` is twice the signed area in the y-down window, in corner order: counter-clockwise as seen is
// NEGATIVE. A mirrored model (determinant of eye_from_object < 0) turns every winding around. Zero area is
// the caller's case.
constexpr Facing facing(std::int64_t area2, bool mirrored) {
    return ((area2 < 0) != mirrored) ? Facing::Front : Facing::Back;
}

constexpr bool is_culled(Facing facing, Cull cull) {
    return (cull == Cull::Back && facing == Facing::Back) || (cull == Cull::Front && facing == Facing::Front);
}

}  // namespace relevo::pipeline
