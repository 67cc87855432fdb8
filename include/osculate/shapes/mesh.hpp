#pragma once
// A shape's surface as triangles, for pictures, files and checks.

#include <array>
#include <vector>

#include "osculate/core/types.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate {

/// A closed surface, body frame. Triangles turn counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vec3> vertices;                 ///< [m], exactly on the surface
  std::vector<Vec3> normals;                  ///< outward unit normal of the surface at each vertex
  std::vector<std::array<int, 3>> triangles;  ///< three vertex indices each
};

/// The surface of a particle, as a cube's six grids mapped to it: `resolution` cells along a cube edge (rounded up to
/// an even number), 12 resolution² triangles. Vertices crowd where the normal turns, so that faces, edges and corners
/// keep their form. Throws InputError for walls and unless 2 ≤ resolution ≤ 2048.
TriangleMesh surface_mesh(const Shape& shape, int resolution);

}  // namespace osculate
