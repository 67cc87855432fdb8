#pragma once
// The shape of an elastic contact: from the two radii of relative curvature to the ellipse that two bodies touch in.

namespace osculate {

/// What the elliptical theories take from the geometry. Independent of load, overlap and material.
struct ContactEllipse {
  double R_c;         ///< R_i R_j/(R_i + R_j) [m]
  double axis_ratio;  ///< b_c/a_c in (0, 1]
  double e2;          ///< e² = 1 − (b_c/a_c)², to full relative precision also when nearly circular
  double K;           ///< complete elliptic integrals of parameter e²
  double E;
  bool ratio_limited;  ///< R_i/R_j exceeded largest_radius_ratio and was replaced by it: nearly a line contact

  /// Force: F = 4/3 Ê R_c^{1/2} δ^{3/2} γ with γ = π/(2K) · (2E/K)^{1/2} · a/b.                      [KDY23 (11)]
  double gamma() const;
  /// Area: a_c b_c = β R_c δ with β = 2E/K · a/b.                                                    [KDY23 (12)]
  double beta() const;
};

/// Beyond this R_i/R_j the axis ratio is held. A flat direction (R_i = ∞) is a line contact, whose Hertz force at a
/// given overlap has no limit; every real body ends long before such an ellipse does.
inline constexpr double largest_radius_ratio = 1e12;

/// The exact ellipse: solves R_j/R_i = (1 − m) D(m)/B(m) for m = e² to the last digits.               [KDY23 (13)]
/// The review writes the ratio as R_i/R_j; it must be ≤ 1. The root m = 0 that its form has for every ratio is not one
/// here. Relative error below 5e-15 for ratios from 1 to 1e12.
/// @pre R_i ≥ R_j > 0 [m], R_i may be ∞; else throws InputError
ContactEllipse contact_ellipse(double R_i, double R_j);

/// The review's approximation of the axis ratio, with λ = R_j/R_i,                             [KDY23 (14); Moes00]
///   a/b = 1 + (ln(16/λ)/(2λ))^{1/2} − (ln 4)^{1/2} + 0.16 ln λ.
/// γ is wrong by −0.02 % at R_i/R_j = 1.2, −0.19 % at 5, +0.24 % at 44, +0.45 % at 1000. For comparison only:
/// `contact_ellipse` is exact. Same preconditions.
ContactEllipse contact_ellipse_approximate(double R_i, double R_j);

}  // namespace osculate
