#pragma once
// How curved a shape's surface is at a point: eigenvalues of the tangent-plane Hessian over |gradient|.

#include "osculate/geometry/contact_geometry.hpp"
#include "osculate/shapes/shape.hpp"

namespace osculate {

/// Principal curvatures and the direction of the larger one, body frame, of the surface at the point on the ray through
/// `point_b` ≠ 0 (for walls: at the wall's nearest point). Positive where convex; ≥ 0 on every particle.
/// The 2×2 eigenproblem is solved as it stands: the printed directions (9),(10) are 0/0 where the axes are
/// principal.                                                                                     [KDY23 (5)–(10)]
/// - On faces of n > 2 superquadrics a curvature is exactly 0.
/// - On a rim of n < 2 it is infinite: a number of order 1e100/length stands for it. So it is at the poles if n1 < 2.
/// - At a pole with n1 = 2 ≠ n2 the curvature depends on the direction of approach: that of the diagonal is returned.
/// - Where a plane of a potential particle comes into play the curvature jumps: the inner side's is returned.
/// - Where both are equal the direction is a fixed one for each normal.
/// Throws InputError if point_b of a particle is zero or not finite.
PrincipalCurvatures principal_curvatures(const Shape& shape, const Vec3& point_b);

}  // namespace osculate
