// All stages on one picture, small: for print, and for the README.
#pragma once
#include <span>

#include "samples/show/canvas.hpp"

namespace relevo::show {

inline constexpr int thumbnail_width = 240, thumbnail_height = 180;

// The picture shrunk to fit into thumbnail_width x thumbnail_height, each pixel the average of those that it
// stands for. A smaller picture keeps its size.
Picture thumbnail(const Picture& page);

// Thumbnails in rows of four, in their order; a shorter last row stands in the middle.
Picture strip(std::span<const Picture> thumbnails);

}  // namespace relevo::show
