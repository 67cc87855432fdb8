#pragma once
// From two bodies' principal curvatures to the relative radii that the force laws take.

#include <limits>

#include "osculate/geometry/contact_geometry.hpp"

namespace osculate {

/// Eigenvalues of the summed shape operators in the plane normal to `normal`.        [KDY23 (3),(4)]
/// Directions and normal share one frame; the normal is a unit vector of either sign. Concave walls have negative
/// curvatures.
/// `radius_cap` > 0 [m] is the largest radius reported (the review's curvature floor is 10 R_vol); ∞ reports R as it
/// is. The result says when a radius was capped.
/// - A sum ≤ 0 along a direction (flat on flat, or a body that fits its wall as closely as the wall is curved or less)
///   has no radius of its own: R = ∞, or the cap. Hertz's theory does not hold there.
/// - Where every direction is principal the major axis is a fixed tangent for each normal, the same for n and −n.
/// - The major axis points to the positive side of its largest component, so that swapped bodies agree.
RelativeCurvature relative_curvature(const Vec3& normal, const PrincipalCurvatures& curvature_1,
                                     const PrincipalCurvatures& curvature_2,
                                     double radius_cap = std::numeric_limits<double>::infinity());

}  // namespace osculate
