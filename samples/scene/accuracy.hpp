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

inline constexpr std::string_view ulp = "2^-24", double_ulp = "2^-52";

inline constexpr AccuracyRow accuracy_rows[] = {
    // pipeline/elementary.hpp, normalize.hpp
    {"sin", "real numbers", "any angle up to a million degrees", 1, double_ulp, 1},
    {"cos", "real numbers", "any angle up to a million degrees", 1, double_ulp, 1},
    {"tan", "real numbers", "any angle up to a million degrees", 4, "2^-52 of the result", 1},
    {"log2", "real numbers", "x > 0", 4, "2^-52 of the result", 1},
    {"exp2", "real numbers", "-1000 to 1000", 4, "2^-52 of the result", 1},
    {"power, exponent 32", "real numbers", "0.4 < x < 1, result over 2^-120", 32, "2^-24 of the result", 1},
    {"power, whole exponent", "real numbers", "exponent 1 to 128, result over 2^-120", 128,
     "2^-24 of the result", 1},
    {"power, any exponent", "real numbers", "exponent 0.01 to 1000, result over 2^-120", 1.01,
     "2^-24 of the result", 1},
    {"normalize", "real numbers", "any length", 3, "2^-24", 1},
    // from a vertex to the numbers of a pixel
    {"vertex to clip space", "exact product", "any camera, any vertex", 4,
     "2^-24 of the sum of the terms' sizes", 1},
    {"snapping", "exact position", "up to 8192 x 8192 pixels", 0.00195315, "pixel", 1},
    {"clipped corner", "exact crossing", "any edge that crosses a plane", 1,
     "2^-24 of the ends' largest coordinate", 1},
    {"barycentric weight", "E / area", "any triangle in 8192 x 8192 pixels", 4, "2^-24 of the weight", 1},
    {"depth", "plane through the corners", "any triangle in 8192 x 8192 pixels", 1,
     "2^-23 of the largest corner depth", 1},
    {"perspective u, v", "exact", "w ratio up to 1000", 8, "2^-24 of the largest corner value", 1},
    // light, texture, output
    {"light", "the light equation", "a point light, shininess 32", 200, "2^-24 of the light", 1},
    {"texture, nearest", "the texel that holds u", "1024 texels, u from -1 to 2", 0.001, "texel", 1},
    {"texture, bilinear", "real weights", "64 x 64 texels, u, v from -2 to 2", 0.005,
     "of the texels' difference", 1},
    {"output, srgb", "the sRGB curve", "any light", 0.5, "of 255", 1},
    {"output, raw", "255 c", "any light", 0.50001, "of 255", 1},
    {"srgb texel", "the sRGB curve", "any code", 0.5, "of 65535", 0},
    // settings
    {"gouraud, diffuse, 10 degrees", "phong", "corner normals 10 degrees apart", 0.05, "of the light", 1},
    {"gouraud, diffuse, 20 degrees", "phong", "corner normals 20 degrees apart", 0.1, "of the light", 1},
    {"gouraud, diffuse, 40 degrees", "phong", "corner normals 40 degrees apart", 0.2, "of the light", 1},
    {"gouraud, specular, 10 degrees", "phong", "corner normals 10 degrees apart", 0.2, "of the light", 1},
    {"gouraud, specular, 20 degrees", "phong", "corner normals 20 degrees apart", 0.5, "of the light", 1},
    {"gouraud, specular, 40 degrees", "phong", "corner normals 40 degrees apart", 1, "of the light", 1},
    {"flat, diffuse, 10 degrees", "phong", "corner normals 10 degrees apart", 0.1, "of the light", 1},
    {"flat, diffuse, 20 degrees", "phong", "corner normals 20 degrees apart", 0.2, "of the light", 1},
    {"flat, diffuse, 40 degrees", "phong", "corner normals 40 degrees apart", 0.4, "of the light", 1},
    {"flat, specular, 10 degrees", "phong", "corner normals 10 degrees apart", 0.5, "of the light", 1},
    {"flat, specular, 20 degrees", "phong", "corner normals 20 degrees apart", 0.7, "of the light", 1},
    {"flat, specular, 40 degrees", "phong", "corner normals 40 degrees apart", 1, "of the light", 1},
    {"float32-reversed at 0.2", "distance", "near 0.1, far 10000", 3e-7, "of the distance", 0},
    {"float32-reversed at 30", "distance", "near 0.1, far 10000", 3e-7, "of the distance", 0},
    {"float32-reversed at 1000", "distance", "near 0.1, far 10000", 3e-7, "of the distance", 0},
    {"float32-reversed at 9000", "distance", "near 0.1, far 10000", 3e-7, "of the distance", 0},
    {"float32-forward at 0.2", "distance", "near 0.1, far 10000", 3e-7, "of the distance", 0},
    {"float32-forward at 30", "distance", "near 0.1, far 10000", 3e-5, "of the distance", 0},
    {"float32-forward at 1000", "distance", "near 0.1, far 10000", 1e-3, "of the distance", 0},
    {"float32-forward at 9000", "distance", "near 0.1, far 10000", 1e-2, "of the distance", 0},
};

inline std::span<const AccuracyRow> accuracy_table() { return accuracy_rows; }

}  // namespace relevo::scene
