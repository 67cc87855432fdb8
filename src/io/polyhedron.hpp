#pragma once
// Polyhedra as other programs write them: OFF, STL (ascii and binary) and OBJ.

#include <filesystem>
#include <vector>

#include "osculate/core/types.hpp"

namespace osculate::io {

/// Vertices and the polygons between them, in the file's own unit of length. Polygons may be missing: a cloud of
/// points.
struct Polyhedron {
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> polygons;  ///< vertex indices from 0
};

/// Reads a file by its ending (.off, .stl, .obj). Throws InputError with file and line (STL binary: triangle) for
/// anything that is not such a file, for coordinates that are not finite and for indices that name no vertex.
/// An STL file repeats vertices for each triangle; they are kept as they stand.
Polyhedron read_polyhedron(const std::filesystem::path& path);

}  // namespace osculate::io
