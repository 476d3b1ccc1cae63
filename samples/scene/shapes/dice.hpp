// A dice: the cube of edge 1 round the origin, whose faces look at six parts of one picture, the unfolded
// cube.
//
// Source: textbook, chapter 10 and fig. 10.1. The picture has 4 columns and 3 rows:
//
//      +y   .    .    .
//      +z   +x   -z   -x
//      -y   .    .    .
//
// The printed file has wrong normals on four faces, gives the top (+y) two rows of the picture, and ends its
// rows at 0.33 and 0.66; here every face has its own normal and its own cell, and the rows are exact thirds.
#pragma once
#include "samples/scene/shapes/cube.hpp"

namespace relevo::scene {

inline Mesh dice() {
    constexpr glm::dvec2 cells[6] = {{0, 1}, {1, 1}, {2, 1},
                                     {3, 1}, {0, 2}, {0, 0}};  // column, row from below
    return cube_mesh([&](int face, glm::dvec2 corner) {
        const glm::dvec2 cell = cells[face] + corner;
        return glm::dvec2(cell.x / 4, cell.y / 3);
    });
}

}  // namespace relevo::scene
