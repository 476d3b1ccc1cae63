// The accuracy table: one row for each place where the machine computes with less than exact arithmetic, and
// for each setting that trades exactness for speed. `relevo list knobs --accuracy` prints it.
//
// Every row is checked: tests/accuracy measures the error, which must be at most the allowed one and at least
// a quarter of it; `scripts/instructions` counts the instructions. To add a row:
// tests/accuracy/measurement.hpp.
#pragma once
#include <span>
#include <string_view>

namespace relevo::scene {

struct AccuracyRow {
    std::string_view name;       // what is approximated
    std::string_view reference;  // what it is measured against
    std::string_view domain;     // for which inputs the error holds
    double allowed_error;
    std::string_view unit;  // of allowed_error
    int instructions;       // a call, built by g++ -O3 for x86-64-v3; 0: no code of its own
};

inline constexpr AccuracyRow accuracy_rows[] = {
    // pipeline/elementary.hpp, normalize.hpp
    {"sin", "real numbers", "any angle up to a million degrees", 1, "2^-52", 74},
    {"cos", "real numbers", "any angle up to a million degrees", 1, "2^-52", 76},
    {"tan", "real numbers", "any angle up to a million degrees", 2, "2^-52 of the result", 158},
    {"direction", "real numbers", "any direction", 1, "2^-44 degrees", 122},
    {"log2", "real numbers", "x > 0", 2, "2^-52 of the result", 72},
    {"exp2", "real numbers", "-1000 to 1000", 1, "2^-52 of the result", 92},
    {"power, exponent 32", "real numbers", "0.4 < x < 1, result > 2^-120", 32, "2^-24 of the result", 36},
    {"power, whole exponent", "real numbers", "exponent 1 to 128, result > 2^-120", 128,
     "2^-24 of the result", 29},
    {"power, any exponent", "real numbers", "exponent up to 1000, result > 2^-120", 1.01,
     "2^-24 of the result", 184},
    {"normalize", "real numbers", "any length", 3, "2^-24", 21},
    // from a vertex to the numbers of a pixel
    {"vertex to clip space", "exact product", "any camera, any vertex", 4, "2^-24 of the terms", 28},
    {"snapping", "exact position", "up to 8192 x 8192 pixels", 0.00195315, "pixel", 26},
    {"clipped corner", "exact crossing", "any edge that crosses a plane", 1, "2^-24 of the ends", 25},
    {"perspective weight", "exact", "w ratio up to 1000", 1, "2^-24", 16},
    {"depth", "plane through the corners", "any triangle in 8192 x 8192 pixels", 1, "2^-23 of the corners",
     9},
    {"perspective u, v", "exact", "w ratio up to 1000", 8, "2^-24 of the corners", 27},
    // light, texture, output
    {"light", "the light equation", "a point light, shininess 32", 150, "2^-24 of the light", 197},
    {"texture, nearest", "the texel that holds u", "1024 texels, u from -1 to 2", 0.0001, "texel", 39},
    {"texture, bilinear", "real weights", "64 x 64 texels, u, v from -2 to 2", 0.004, "of the contrast", 112},
    {"output, srgb", "the sRGB curve", "any light", 0.5, "of 255", 16},
    {"output, raw", "255 c", "any light", 0.50001, "of 255", 9},
    {"srgb texel", "the sRGB curve", "any code", 0.5, "of 65535", 0},
    // settings
    {"gouraud, diffuse, 10 degrees", "phong", "corner normals 10 degrees apart", 0.044, "of the light", 19},
    {"gouraud, diffuse, 20 degrees", "phong", "corner normals 20 degrees apart", 0.087, "of the light", 19},
    {"gouraud, diffuse, 40 degrees", "phong", "corner normals 40 degrees apart", 0.172, "of the light", 19},
    {"gouraud, specular, 10 degrees", "phong", "corner normals 10 degrees apart", 0.39, "of the light", 19},
    {"gouraud, specular, 20 degrees", "phong", "corner normals 20 degrees apart", 0.87, "of the light", 19},
    {"gouraud, specular, 40 degrees", "phong", "corner normals 40 degrees apart", 1, "of the light", 19},
    {"flat, diffuse, 10 degrees", "phong", "corner normals 10 degrees apart", 0.088, "of the light", 7},
    {"flat, diffuse, 20 degrees", "phong", "corner normals 20 degrees apart", 0.174, "of the light", 7},
    {"flat, diffuse, 40 degrees", "phong", "corner normals 40 degrees apart", 0.343, "of the light", 7},
    {"flat, specular, 10 degrees", "phong", "corner normals 10 degrees apart", 0.56, "of the light", 7},
    {"flat, specular, 20 degrees", "phong", "corner normals 20 degrees apart", 0.9, "of the light", 7},
    {"flat, specular, 40 degrees", "phong", "corner normals 40 degrees apart", 1, "of the light", 7},
    {"float32-reversed at 0.2", "distance", "near 0.1, far 10000", 1.3e-7, "of the distance", 0},
    {"float32-reversed at 30", "distance", "near 0.1, far 10000", 1.3e-7, "of the distance", 0},
    {"float32-reversed at 1000", "distance", "near 0.1, far 10000", 1.3e-7, "of the distance", 0},
    {"float32-reversed at 9000", "distance", "near 0.1, far 10000", 1.3e-7, "of the distance", 0},
    {"float32-forward at 0.2", "distance", "near 0.1, far 10000", 1.5e-7, "of the distance", 0},
    {"float32-forward at 30", "distance", "near 0.1, far 10000", 1.9e-5, "of the distance", 0},
    {"float32-forward at 1000", "distance", "near 0.1, far 10000", 7e-4, "of the distance", 0},
    {"float32-forward at 9000", "distance", "near 0.1, far 10000", 0.011, "of the distance", 0},
    {"path, fast", "path, textbook", "any scene", 0, "of the pixels differ", 0},
    // lines, instructions a step
    {"line, dda", "line, midpoint", "lines on 1024 x 1024 pixels", 0.004, "of the pixels differ", 15},
    {"line, dda, sum", "exact sum", "lines on 1024 x 1024 pixels", 0.03, "pixel", 0},
    {"line, wu", "exact area", "width 1", 0.34, "of full coverage", 24},
    {"line, wu, rms", "exact area", "width 1", 0.085, "of full coverage", 0},
    {"line, gupta-sproull", "exact cone over the rectangle", "width 0.5 to 4", 0.01, "of full coverage", 252},
    {"line, gupta-sproull, rms", "exact cone over the rectangle", "width 0.5 to 4", 0.001, "of full coverage",
     0},
    {"cone table", "exact volume", "any distance", 3e-6, "of the cone", 18},
    // circles and ellipses, instructions a pixel of the edge
    {"disc, area", "exact area", "radii 0.05 to 60", 2.5e-5, "of full coverage", 114},
    {"disc, area, rms", "exact area", "radii 0.05 to 60", 1e-5, "of full coverage", 0},
    {"ring, area", "exact area", "radii 0.05 to 60, width 0.25 to 8", 4e-5, "of full coverage", 142},
    {"ring, area, rms", "exact area", "radii 0.05 to 60, width 0.25 to 8", 1.2e-5, "of full coverage", 0},
    // antialiasing, instructions a step of a line one pixel wide
    {"area coverage", "exact area", "any triangle", 1.5, "2^-16 of the pixel", 275},
    {"area coverage, rms", "exact area", "pixels on the border", 0.35, "2^-16 of the pixel", 0},
    {"weighted coverage", "exact volume of the cone", "a corner anywhere in it", 0.51, "2^-16 of the cone",
     1532},
    {"1 x 1 samples", "exact area", "an edge through the pixel", 0.501, "of full coverage", 374},
    {"1 x 1 samples, rms", "exact area", "an edge through the pixel", 0.25, "of full coverage", 0},
    {"2 x 2 samples", "exact area", "an edge through the pixel", 0.25, "of full coverage", 669},
    {"2 x 2 samples, rms", "exact area", "an edge through the pixel", 0.087, "of full coverage", 0},
    {"4 x 4 samples", "exact area", "an edge through the pixel", 0.125, "of full coverage", 1214},
    {"4 x 4 samples, rms", "exact area", "an edge through the pixel", 0.03, "of full coverage", 0},
    {"8 x 8 samples", "exact area", "an edge through the pixel", 0.0625, "of full coverage", 2321},
    {"8 x 8 samples, rms", "exact area", "an edge through the pixel", 0.0104, "of full coverage", 0},
    {"16 x 16 samples", "exact area", "an edge through the pixel", 0.03125, "of full coverage", 4637},
    {"16 x 16 samples, rms", "exact area", "an edge through the pixel", 0.0038, "of full coverage", 0},
    // relief textures: the worst of three objects (tests/accuracy/relief.cpp)
    {"relief, splat", "rays cast at the object", "25 degrees aside", 34, "% of the pixels bad", 0},
    {"relief, one-dimensional", "rays cast at the object", "25 degrees aside", 39, "% of the pixels bad", 0},
    {"relief, asymmetric", "rays cast at the object", "25 degrees aside", 40, "% of the pixels bad", 0},
    {"relief, compensated", "rays cast at the object", "25 degrees aside", 40, "% of the pixels bad", 0},
    {"relief, interleaved", "rays cast at the object", "25 degrees aside", 37, "% of the pixels bad", 0},
    {"relief, mesh", "rays cast at the object", "25 degrees aside", 37, "% of the pixels bad", 0},
    {"relief, skin, missing", "rays cast at the object", "25 degrees aside", 7.4, "% missing", 0},
    {"relief, cut", "rays cast at the object", "25 degrees aside", 27, "% of the pixels bad", 0},
    {"relief, cut, missing", "rays cast at the object", "25 degrees aside", 23, "% missing", 0},
    {"relief, perspective source", "rays cast at the object", "25 degrees aside", 41, "% of the pixels bad",
     0},
    {"relief, 16-bit displacement", "rays cast at the object", "25 degrees aside", 37, "% of the pixels bad",
     0},
    {"relief, 8-bit displacement", "rays cast at the object", "25 degrees aside", 37, "% of the pixels bad",
     0},
    {"16-bit displacement", "float displacement", "256 x 256 texels, seen from 1.6 before the plane", 0.0012,
     "texel", 0},
    {"8-bit displacement", "float displacement", "256 x 256 texels, seen from 1.6 before the plane", 0.31,
     "texel", 0},
    {"8 slices", "the surface of the texels", "seen from the front, depths 0 to 2", 0.16, "world units, mean",
     0},
    {"16 slices", "the surface of the texels", "seen from the front, depths 0 to 2", 0.074,
     "world units, mean", 0},
    {"32 slices", "the surface of the texels", "seen from the front, depths 0 to 2", 0.036,
     "world units, mean", 0},
    {"64 slices", "the surface of the texels", "seen from the front, depths 0 to 2", 0.018,
     "world units, mean", 0},
    {"128 slices", "the surface of the texels", "seen from the front, depths 0 to 2", 0.0088,
     "world units, mean", 0},
    {"256 slices", "the surface of the texels", "seen from the front, depths 0 to 2", 0.0043,
     "world units, mean", 0},
    {"32 slices, 8 bisections", "the surface of the texels", "seen from the front, depths 0 to 2", 0.00014,
     "world units, mean", 0},
    {"layers, 1", "rays cast at the object", "25 degrees aside", 23, "% missing", 0},
    {"layers, 2", "rays cast at the object", "25 degrees aside", 11.5, "% missing", 0},
    {"layers, 4", "rays cast at the object", "25 degrees aside", 2.3, "% missing", 0},
    {"layers, 6", "rays cast at the object", "25 degrees aside", 0.65, "% missing", 0},
    {"morphing, plain", "rays cast at the object", "between views 30 degrees apart", 58,
     "% of the pixels bad", 0},
    {"morphing, view", "rays cast at the object", "between views 30 degrees apart", 10.7,
     "% of the pixels bad", 0},
    {"self-shadow", "rays cast at the object", "a far light, 25 degrees aside", 7.1, "% of the pixels", 0},
    {"relief box, 1 face", "all that is visible", "a full turn, and 60 degrees up and down", 100, "% missing",
     0},
    {"relief box, 2 faces", "all that is visible", "a full turn, and 60 degrees up and down", 100,
     "% missing", 0},
    {"relief box, 3 faces", "all that is visible", "a full turn, and 60 degrees up and down", 56, "% missing",
     0},
    {"relief box, 4 faces", "all that is visible", "a full turn, and 60 degrees up and down", 31, "% missing",
     0},
    {"relief box, 5 faces", "all that is visible", "a full turn, and 60 degrees up and down", 30, "% missing",
     0},
    {"relief box, 6 faces", "all that is visible", "a full turn, and 60 degrees up and down", 9.4,
     "% missing", 0},
};

inline std::span<const AccuracyRow> accuracy_table() { return accuracy_rows; }

}  // namespace relevo::scene
