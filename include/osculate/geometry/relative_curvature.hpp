#pragma once
// From two bodies' principal curvatures to the relative radii that the force laws take.

#include <limits>

#include "osculate/geometry/contact_geometry.hpp"

namespace osculate {

/// Eigenvalues of the summed shape operators in the plane normal to `normal`.        [KDY23 (3),(4)]
/// `radius_cap` [m] is the largest radius reported (the review's curvature floor is 10 R_vol); ∞ reports R as it is.
/// The result says when a radius was capped.
RelativeCurvature relative_curvature(const Vec3& normal, const PrincipalCurvatures& curvature_1,
                                     const PrincipalCurvatures& curvature_2,
                                     double radius_cap = std::numeric_limits<double>::infinity());

}  // namespace osculate
