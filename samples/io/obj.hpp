// Wavefront OBJ meshes with their MTL materials, by a reader that checks every token.
//
// Source: Wavefront Advanced Visualizer, appendix B "Object files" and the MTL description, 1995.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/light.hpp"
#include "pipeline/mesh.hpp"
#include "samples/io/place.hpp"

namespace relevo::io {

struct ObjMaterial {
    std::string name;
    pipeline::Material material;
    std::string texture_path;  // map_Kd, relative to the MTL file's folder; empty without one
    // By d < 1, map_d or, without a d, Tr > 0. Everything is drawn opaque; but a relief texture, which keeps
    // one surface a texel, would be wrong.
    bool transparent = false;
};

// The faces of one object (or group) with one material.
struct ObjPart {
    std::string name;  // of the object, of the group, or "object group"; empty before the first one
    pipeline::Mesh mesh;
    std::optional<ObjMaterial> material;
    bool had_normals = false, had_uv = false;  // true when every corner of the part had its own
};

// Reads a file with the statements v vt vn f o g usemtl mtllib. Statements of OBJ that draw no faces (l, p,
// s, curves...) are skipped; a word that is no statement is an error. The parts come in the order of their
// first faces.
//
// Polygons are cut into fans from their first corner. Equal corners (same v, t and n) are one vertex,
// numbered by first use. A corner without a normal gets the average over the faces without normals that share
// its position, weighted by their areas; a corner without texture coordinates gets (0, 0).
//
// Errors, at the exact token: not a finite float32, a missing coordinate, an index that is 0 or outside its
// list, a face of fewer than 3 corners, an unknown statement, material or material file; and a file that is
// missing, empty, binary, larger than max_text_file, or without faces. Faces without area are legal.
FileResult<std::vector<ObjPart>> read_obj(const std::string& path);

// The same for a text in memory; `path` names it in errors and says where its material files lie.
FileResult<std::vector<ObjPart>> parse_obj(std::string_view text, const std::string& path);

}  // namespace relevo::io
