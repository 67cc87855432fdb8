#pragma once
// The answer of the narrow phase: where two bodies touch, how deeply, and how curved both are there.

#include <string_view>

#include "osculate/core/types.hpp"

namespace osculate {

enum class ContactStatus {
  touching,       ///< overlap ≥ 0
  separated,      ///< overlap < 0: a gap
  ambiguous,      ///< converged, but another common normal is as good within round-off: only the overlap is meaningful
  flat,           ///< converged, but the bodies meet over a flat set: the point is its centre as nearly as can be
  not_converged,  ///< the normal is the best found, the overlap an upper bound of the true one
  degenerate,     ///< no answer exists (for instance a non-finite pose): every number is zero
};

std::string_view name(ContactStatus status);

/// True when the numbers of a contact may be used.
constexpr bool is_resolved(ContactStatus status) {
  return status != ContactStatus::not_converged && status != ContactStatus::degenerate;
}

/// Principal curvatures of one body's surface, positive where convex.
struct PrincipalCurvatures {
  double max = 0.0;                   ///< k_max ≥ k_min [1/m]
  double min = 0.0;                   ///< [1/m]
  Vec3 max_direction = Vec3::Zero();  ///< unit tangent of k_max, world frame

  double mean() const { return 0.5 * (max + min); }
  double gaussian() const { return max * min; }
};

/// Radii of relative curvature: 1/R_i ≤ 1/R_j are the eigenvalues of the summed shape operators.
/// A flat direction has R = ∞ unless the caller set a cap.
struct RelativeCurvature {
  double R_i = 0.0;                ///< the larger radius [m]; its direction carries the major semi-axis a_c
  double R_j = 0.0;                ///< the smaller radius [m]
  Vec3 major_axis = Vec3::Zero();  ///< unit tangent along a_c, world frame
  bool capped = false;             ///< a radius was larger than the cap and was replaced by it
};

/// One contact between two convex bodies. World frame.
struct ContactGeometry {
  ContactStatus status = ContactStatus::degenerate;
  Vec3 normal = Vec3::Zero();  ///< unit, from body 1 to body 2
  double overlap = 0.0;        ///< δ [m], (on_1 − on_2)·normal; negative is a gap
  Vec3 on_1 = Vec3::Zero();    ///< body 1's surface point with outward normal `normal` [m]
  Vec3 on_2 = Vec3::Zero();    ///< body 2's surface point with outward normal −`normal` [m]
  PrincipalCurvatures curvature_1;
  PrincipalCurvatures curvature_2;
  RelativeCurvature relative;

  Vec3 point() const { return 0.5 * (on_1 + on_2); }  ///< the contact point [m]
};

}  // namespace osculate
