#pragma once
// Simplified models of a contact's curvature, to compare with the exact one. Each body becomes a sphere of some radius
// and the contact a circular one.

#include <string_view>

#include "osculate/geometry/contact_geometry.hpp"

namespace osculate {

enum class CurvatureModel {
  exact,              ///< the summed shape operators
  gaussian,           ///< each body's R = 1/√(k_max k_min)                         [KDY23 (17),(18)]
  mean,               ///< each body's R = 2/(k_max + k_min)
  volume_equivalent,  ///< each body's R = R_vol
};

/// "exact", "gaussian", "mean", "volume-equivalent".
std::string_view name(CurvatureModel model);

/// One body at a contact.
struct ContactBody {
  PrincipalCurvatures curvature;
  double volume_radius;  ///< R_vol > 0 [m] of a particle; ∞ for a wall
};

/// The review's curvature floor: no radius above 10 R_vol of its body.
constexpr double review_cap = 10.0;

/// Relative radii for the elliptical Hertz theory. The simplified models return R_i = R_j = R with
/// 1/R = 1/R_1 + 1/R_2, for which it becomes the circular one (γ √R_c = √R).
/// `cap` · R_vol is the largest radius: of each body in the gaussian and mean models; of the contact, with the smaller
/// R_vol of the two, in the exact one. ∞ does not cap.
/// - A flat body without a cap (a plane wall) contributes nothing. Concave walls contribute a negative curvature; a sum
///   ≤ 0 gives ∞, as in `relative_curvature`.
/// - A wall has no R_vol: in the volume-equivalent model it contributes its mean curvature.
/// `capped` says that a radius was replaced.
RelativeCurvature relative_curvature(CurvatureModel model, const Vec3& normal, const ContactBody& body_1,
                                     const ContactBody& body_2, double cap = review_cap);

}  // namespace osculate
