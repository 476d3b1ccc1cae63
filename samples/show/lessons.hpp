// The lessons of a two-dimensional scene: for each shape how it is clipped, how it becomes pixels, how its
// edges are smoothed. Each function runs the algorithm of one shape with a probe and tells what it heard.
#pragma once
#include <cstddef>
#include <vector>

#include "samples/scene/scene.hpp"
#include "samples/show/lesson.hpp"

namespace relevo::show {

// All lessons of the scene in the order of its shapes. Names are unique: "02-line-midpoint".
std::vector<Lesson> lessons(const scene::LoadedScene& loaded);

// The lessons of one shape, empty when it is not of that family.
std::vector<Lesson> clipping_lessons(const scene::LoadedScene& loaded, std::size_t shape);
std::vector<Lesson> line_lessons(const scene::LoadedScene& loaded, std::size_t shape);
std::vector<Lesson> curve_lessons(const scene::LoadedScene& loaded, std::size_t shape);
std::vector<Lesson> area_lessons(const scene::LoadedScene& loaded, std::size_t shape);  // triangles, polygons
std::vector<Lesson> antialiasing_lessons(const scene::LoadedScene& loaded, std::size_t shape);

}  // namespace relevo::show
