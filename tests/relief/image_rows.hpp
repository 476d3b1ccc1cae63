// The figures of the image experiment: every scene from four places, drawn in every way, by the error set.
// A test holds them (image_experiment_test.cpp), a program writes them down (image_table.cpp).
//
//   sphere, bumpy, complex, checker_cube   image_experiment.hpp, against rays through the pixel centres
//   plane_step, bunny                      the same turned by 180 degrees about y: they show their face to
//   +z.
//                                          The bunny is a mesh, captured by our own rasterizer; its truth is
//                                          the mesh itself by our own rasterizer, 16 samples a pixel.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "relief/error_set.hpp"

namespace relevo::tests {

inline constexpr std::array<std::string_view, 6> image_scenes = {"sphere",       "bumpy",      "complex",
                                                                 "checker_cube", "plane_step", "bunny"};
inline constexpr std::array<double, 4> image_azimuths = {0, 10, 25, 40};

// Sprite and inverse, and the warps of relief/prewarp.hpp, in the order of the rows.
inline constexpr std::array<std::string_view, 9> image_ways = {
    "sprite", "one-dimensional",   "asymmetric",  "compensated", "interleaved", "interleaved cut",
    "mesh",   "sprite with depth", "inverse 64+6"};

struct ImageRow {
    std::string_view way;
    relief::ErrorSet error, asked;
    bool psnr_by_design;  // the design asks for that PSNR; else it is the first figure that we had
};
// PSNR may be 0.1 dB below what is asked; percentages 0.1 and a twentieth above, the mean error of depth
// 0.0002 and a twentieth: the edges of two builds, and of two right resamplers, differ by as much.
bool met(const ImageRow& row);

// One row a way. The bunny's file may be missing: then there is none (glmark2-data has it).
std::vector<ImageRow> image_rows(std::string_view scene, double azimuth);

}  // namespace relevo::tests
