#pragma once
// Potential particles: rounded convex polyhedra given by face planes.              [Houlsby09]
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

/// f and its derivatives. f is convex, once continuously differentiable and piecewise quadratic: the Hessian jumps
/// where a plane comes into play.
struct ImplicitValue {
  double value;   ///< f(x) [-], −1 at the origin, negative inside
  Vec3 gradient;  ///< ∇f [1/m]
  Mat3 hessian;   ///< ∇∇f [1/m²], positive definite; on a plane itself, that of the inner side
};

/// Throws InputError, naming the plane, unless normals are unit vectors to 1e-9, distances positive, the planes bound a
/// volume, k in (0, 1], r and R positive, and planes and sphere of sizes that make sense together.
void validate(const PotentialParticle& shape);

/// f, ∇f and ∇∇f at x, body frame [m].                                           [KDY23 (16)]
ImplicitValue implicit_value(const PotentialParticle& shape, const Vec3& x);

/// The gauge that belongs to f = 0; x ≠ 0, body frame [m]. At x = 0 all is zero.
Gauge gauge(const PotentialParticle& shape, const Vec3& x);

/// The surface point with outward normal u [m]: maximises u·x on f ≤ 0. At u = 0 it is zero.
Vec3 support_point(const PotentialParticle& shape, const Vec3& u);

/// Radius of a sphere about the origin that certainly holds the body [m]: the largest radius searched by branch and
/// bound, 1e-9 above it as a rule and never more than 1 % (bodies near a sphere, where no direction can be excluded).
double bounding_radius(const PotentialParticle& shape);

OrientedBox oriented_box(const PotentialParticle& shape);

/// By adaptive quadrature over directions, a quarter of a second. `relative_error` is a cautious estimate for volume
/// and inertia, 1e-6 or better unless the edges are sharper than a hundredth of the body; the error is some ten times
/// smaller.
MassProperties mass_properties(const PotentialParticle& shape);

}  // namespace osculate
