// Short ways to write the marks of a lesson's frame, in pixels of the scene.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "samples/show/lesson.hpp"

namespace relevo::show {

inline Mark mark(Mark::Kind kind, Rgba8 color, std::vector<Spot> points) {
    return {kind, color, std::move(points), 0, 0, 255, {}};
}
// The whole square of a pixel.
inline Mark cell(Spot at, Rgba8 color, int level = 255) {
    return {Mark::Kind::Cell, color, {at}, 0, 0, level, {}};
}
inline Mark label(Spot at, Rgba8 color, std::string text) {
    return {Mark::Kind::Text, color, {at}, 0, 0, 255, std::move(text)};
}
// The `level` of a cell that is covered so much, 0..full_coverage.
inline int level_of(int coverage) {
    return (coverage * 255 + raster::full_coverage / 2) / raster::full_coverage;
}
inline Spot spot_of(raster::Pixel p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

}  // namespace relevo::show
