// The materials of a Wavefront MTL file.
//
// Source: the MTL description of Wavefront's Advanced Visualizer, 1995. Its light is Ka Ia + Kd n.l + Ks
// (r.v)^Ns by colour; pipeline::Material has one base colour, a scalar for each kind of light, and white
// highlights:
//   diffuse  = the largest channel of Kd        color   = Kd / diffuse
//   specular = the mean of Ks                   ambient = 0.1 times the mean of Ka (the file leaves Ia to us)
#pragma once
#include <string>
#include <vector>

#include "samples/io/obj.hpp"

namespace relevo::io {

// Reads newmtl Ka Kd Ks Ns map_Kd, and d Tr map_d for whether it is transparent; other statements are
// ignored. What a material leaves out keeps the value of pipeline::Material. Channels above 1 count as 1.
// Errors, at the exact token: not a finite float32, below 0, a missing number, an opacity or transparency
// outside 0..1, a statement before the first newmtl, options of map_Kd; and those of read_text.
FileResult<std::vector<ObjMaterial>> read_mtl(const std::string& path);

// `name` seen from the folder of `file`: backslashes (of Windows) are slashes, absolute paths stay.
std::string path_beside(const std::string& file, std::string_view name);

}  // namespace relevo::io
