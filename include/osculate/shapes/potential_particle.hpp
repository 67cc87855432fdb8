#pragma once
// Potential particles: rounded convex polyhedra given by face planes.              [KDY23 (16), Houlsby09]
//   f(x) = (1−k) [ Σ_i ⟨a_i·x − d_i⟩² / r² − 1 ] + k [ |x|²/R² − 1 ],   f = 0 on the surface, ⟨t⟩ = max(t, 0)
// The review prints + d_i; with outward unit normals a_i and d_i > 0 the sign is − (docs/errata.md).

#include <vector>

#include "osculate/core/types.hpp"
#include "osculate/shapes/surface.hpp"

namespace osculate {

/// The plane normal·x = distance, body frame.
struct FacePlane {
  Vec3 normal;      ///< outward unit normal
  double distance;  ///< d > 0 [m]
};

struct PotentialParticle {
  std::vector<FacePlane> planes;  ///< bound a polytope with the origin inside
  double sphericity;              ///< k in (0, 1]: 0 would be the rounded polyhedron, 1 is the sphere of radius R
  double edge_radius;             ///< r > 0 [m]: how far a face is pushed out, hence the rounding of its edges
  double sphere_radius;           ///< R > 0 [m]: of the sphere that is blended in
};

}  // namespace osculate
