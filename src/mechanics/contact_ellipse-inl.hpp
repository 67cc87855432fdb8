// The contact ellipse over Real (double or Batch): the inverse of R_j/R_i = (1 − m) D(m)/B(m).
#if defined(OSCULATE_MECHANICS_CONTACT_ELLIPSE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_MECHANICS_CONTACT_ELLIPSE_INL
#undef OSCULATE_MECHANICS_CONTACT_ELLIPSE_INL
#else
#define OSCULATE_MECHANICS_CONTACT_ELLIPSE_INL
#endif

#include "mechanics/elliptic_integrals-inl.hpp"
#include "osculate/mechanics/contact_ellipse.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

template <class Real>
struct Ellipse {
  Real R_c, axis_ratio, e2, K, E;
};

template <class Real>
HWY_INLINE Real gamma(const Ellipse<Real>& ellipse) {
  static constexpr double half_pi = 1.5707963267948966;
  return Real(half_pi) * sqrt(Real(2.0) * ellipse.E / ellipse.K) / (ellipse.K * ellipse.axis_ratio);
}

template <class Real>
HWY_INLINE Real beta(const Ellipse<Real>& ellipse) {
  return Real(2.0) * ellipse.E / (ellipse.K * ellipse.axis_ratio);
}

/// ln(b/a) as a function of t = ln(R_i/R_j) in [0, ln 1e12]. Largest error 9.3e-8 (docs/fits/elliptic.py).
template <class Real>
HWY_INLINE Real fitted_log_axis_ratio(const Real& t) {
  static constexpr double slope[] = {
      -0.6666704800147777, 0.0004016860473513105, 0.18272283389623536, 0.6684556025655596, -2.870088008944168,
      18.422608432295814,  -88.24359872250852,    240.2976809222717,   -398.0298337396248, 416.93162263910136,
      -272.4257329122029,  102.02282616185171,    -16.793287963863627,
  };
  return t * polynomial(slope, t * reciprocal(t + Real(8.0)));
}

/// R_i ≥ R_j > 0, R_i/R_j ≤ largest_radius_ratio.
template <class Real>
HWY_INLINE Ellipse<Real> ellipse_of(const Real& R_i, const Real& R_j) {
  const Real one(1.0), half(0.5);
  const Real inverse = one / R_i;
  const Real ratio = R_j * inverse;
  const Real deviation = (R_i - R_j) * inverse;  // 1 − ratio, exact where the radii are nearly equal

  const Real x = fitted_log_axis_ratio(-log(ratio));
  const Real k = exp(x);
  // Both 1 − m1 and 1 − e2 must hold to the digits of the smaller of the two.
  const Real e2 = one - k * k;
  const Real m1 = select(e2 < half, one - e2, k * k);
  const auto [K, E, B, C, D] = elliptic_integrals(e2, m1, Real(-2.0) * x);

  // Newton's step in x = ln(b/a) for ln((1 − m) D/B) = ln ratio, from dD/dx = C − D, dB/dx = −m1 C. The start is so
  // close that one step leaves less than round-off. (1 − m) D − ratio·B is written for whichever end keeps its digits.
  const Real mismatch = select(e2 < half, deviation * B - e2 * (D - C), m1 * D - ratio * B) * reciprocal(ratio * B);
  const Real step = -mismatch * (one - half * mismatch) * B * D * reciprocal(B * D + C * (B + m1 * D));

  // Everything is carried along the step by its Taylor series: dK/dx = −B, dE/dx = m1 D, dm/dx = −2 m1.
  const Real square_step = half * step * step;
  Ellipse<Real> result;
  result.R_c = R_j / (one + ratio);
  result.axis_ratio = k + k * (step + square_step);
  result.e2 = e2 - m1 * Real(2.0) * (step + Real(2.0) * square_step);
  result.K = K - (step * B - square_step * m1 * C);
  result.E = E + m1 * (step * D + square_step * (D + C));
  return result;
}

/// The larger radius as far as ellipse_of takes it.
template <class Real>
HWY_INLINE Real limited(const Real& R_i, const Real& R_j) {
  return min(R_i, Real(largest_radius_ratio) * R_j);
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
