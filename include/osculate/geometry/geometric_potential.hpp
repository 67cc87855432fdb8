#pragma once
// The contact point that several other codes use, for comparison studies: the midway point of two potentials. It is not
// the common normal: the two agree for vanishing overlap and for spheres only.      [Podlozhnyuk17 (20)–(22),(37)]
//   minimise F1(x) + F2(x) subject to F1(x) = F2(x)
//   F = N^p − 1, N the gauge: p = n1 for superquadrics, which is the review's Γ; 2 for all other particles
// Equivalently: both bodies shrink about their origins, N_i = (1 + F)^(1/p_i), until they touch in one point.

#include "osculate/geometry/contact_geometry.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate {

/// World frame. Unlike in ContactGeometry, on_1 and on_2 do not have the common normal as their own.
struct GeometricPotentialContact {
  ContactStatus status = ContactStatus::degenerate;
  Vec3 point = Vec3::Zero();        ///< the midway point [m]
  Vec3 normal = Vec3::Zero();       ///< ∇F1/|∇F1| = −∇F2/|∇F2| there, from body 1 to body 2
  double potential = 0.0;           ///< F1 = F2 there; negative where the bodies overlap
  double overlap = 0.0;             ///< δ = (on_1 − on_2)·normal [m]; of a gap, the first-order estimate
  Vec3 on_1 = Vec3::Zero();         ///< where the line through `point` along `normal` leaves body 1 [m]
  Vec3 on_2 = Vec3::Zero();         ///< where it leaves body 2 the other way [m]
  PrincipalCurvatures curvature_1;  ///< of the level surface F1 = const through `point`, not of the body's surface
  PrincipalCurvatures curvature_2;  ///< of F2 = const
  RelativeCurvature relative;       ///< of both
};

/// Midway point of two particles. Minimises (1 − μ) N1² + μ N2² by damped Newton, whose minima for all μ are the points
/// with opposite gradients, and seeks the μ where F1 = F2: it converges from anywhere and is not meant to be fast.
/// - Touching or separated by the sign of the potential, which is exact for convex bodies.
/// - `not_converged` where round-off stops it (exponents near 1, sizes 1e6 apart); the numbers are the best found.
/// - `degenerate` where there is no normal (coincident centres) or a pose is not finite: every number is zero.
/// - A gap has no line to measure along: overlap = −Σ (N_i − 1)/|∇N_i| to first order, on_1 and on_2 accordingly.
/// Throws InputError for walls.
GeometricPotentialContact geometric_potential(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2,
                                              const Pose& pose_2);

}  // namespace osculate
