// What can be seen while the machine of raster/draw_shapes.hpp draws: its own moments. Those of the
// algorithms stand in their headers.
#pragma once
#include <cstddef>

namespace relevo::raster {

struct ShapeStarted {
    std::size_t shape;  // its number in the scene
};
struct ShapeRefused {  // a coordinate, radius or width that is not finite, or beyond largest_place
    std::size_t shape;
};
struct ShapeClipped {  // the window cut an area or a smooth line
    std::size_t shape;
    std::size_t corners_before, corners_after;  // of all outlines; 0 after: nothing is left
};
struct SpanPainted {  // pixels x0 <= x < x1 of row y got a share of the colour
    std::size_t shape;
    int y, x0, x1;
    int coverage;  // 1..65536
};

}  // namespace relevo::raster
