// The textbook's two text formats for solids.
//
// Source: textbook, section 2.4 (vertices, then faces as indices ended by -1) and chapter 10 (vertices,
// normais, textura, faces, where a corner is a vertex, a normal and a texture coordinate). Indices count from
// 0; the corners run counter-clockwise seen from outside.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/mesh.hpp"
#include "samples/io/place.hpp"

namespace relevo::io {

struct SolidMesh {
    pipeline::Mesh mesh;
    bool had_normals = false, had_uv = false;  // both true for the second format, false for the first
    std::vector<std::string> warnings;  // "file:line:column: ..." for every face whose normal contradicts it
};

// A first word that is a number means the first format, `vertices` the second.
//
// First format: every face has corners of its own, with the flat normal of the face. Second format: equal
// corners are one vertex. Faces are convex polygons, cut into fans from their first corner. A `#` starts a
// comment.
//
// Errors, at the exact token: not a finite float32, a count that the rest of the file cannot hold (checked
// before memory is taken), an index outside its list, a face of fewer than 3 corners or without its -1,
// something after the last face; and a file that is missing, empty, binary, larger than max_text_file, or
// without faces.
FileResult<SolidMesh> read_solid(const std::string& path);

// The same for a text in memory; `path` names it in errors.
FileResult<SolidMesh> parse_solid(std::string_view text, const std::string& path);

// Writes the second format; equal positions, normals and texture coordinates are written once. Reading the
// file gives the same triangles with the same numbers. Errors: those of write_file, and numbers that are not
// finite.
Failure write_solid(const std::string& path, const pipeline::Mesh& mesh);

}  // namespace relevo::io
