// Relief textures in files: pictures of colour, normal and depth, and a JSON file beside them that holds the
// camera, says what the pictures' numbers mean, and names them.
//
//   {
//     "relief_texture": 1,                              the version of this form
//     "camera": { "projection": "orthographic",         or "perspective", then with "eye"
//                 "corner": [x, y, z], "a": [x, y, z], "b": [x, y, z], "width": 256, "height": 256 },
//     "numbers": "float",                               or "16 bits", "8 bits"
//     "color": "NAME-color.exr", "normal": "NAME-normal.exr", "depth": "NAME-depth.exr",
//     "coverage": "NAME-coverage.png"                   of "float" only: 0 is empty, anything else a surface
//     "depth_low": 0.25, "depth_high": 1.75             of "16 bits" and "8 bits" only
//   }
//
//              float (EXR)          16 bits (PNG)                  8 bits (PNG)
//   colour     linear light         linear light times 65535       sRGB codes
//   normal     x, y, z              32768 + 32767 n                128 + 127 n
//   depth      as in the texture    codes of relief/quantize.hpp: 0..65534 or 0..254 from depth_low to
//                                   depth_high, 65535 or 255 is empty
//
// Float files hold a relief texture bit for bit (in the double build: rounded to float). Of the others, the
// depth is within half a step, a linear colour in 0..1 within 1/131070 or half an sRGB code, and a normal
// within 1/65534 or 1/254 along each axis before it is made of length 1 again.
#pragma once
#include <string>

#include "relief/relief_texture.hpp"
#include "samples/io/place.hpp"

namespace relevo::io {

enum class ReliefNumbers { Float, Bits16, Bits8 };

// Writes `path`, which ends in ".json", and the pictures beside it: all of them or none. Texels without a
// surface are written as zeros. Errors: what relief::refusal refuses, a colour or a normal of a surface that
// is not finite, another ending, and those of write_files.
Failure refused_relief_name(const std::string& path);  // what write_relief says of another ending
Failure write_relief(const std::string& path, const relief::ReliefTexture& texture, ReliefNumbers numbers);

// Errors, at the place in the JSON file: no JSON, a field that is missing, unknown or of the wrong kind, a
// camera that relief::refusal refuses; and in the pictures: another size, number of channels or kind of
// numbers than the JSON says, numbers that are not finite, a depth that is refused, and what read_pixels
// refuses.
FileResult<relief::ReliefTexture> read_relief(const std::string& path);

}  // namespace relevo::io
