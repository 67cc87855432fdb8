#pragma once
// Where a mesh vertex lies: maps from directions of a sphere to a shape's surface under which equal steps of direction
// share out length and turning of the normal. The idea is the radial map of a body grown by a margin: x + margin · n
// lies along w, so that a sharp edge gets the directions of its rounded strip and a face those of its area.

#include "osculate/shapes/potential_particle.hpp"
#include "osculate/shapes/superquadric.hpp"

namespace osculate {

/// The surface point for direction w ≠ 0 [m]. One-to-one, and symmetric as the shape is.
Vec3 mesh_point(const Superquadric& shape, const Vec3& w);
Vec3 mesh_point(const PotentialParticle& shape, const Vec3& w);

}  // namespace osculate
