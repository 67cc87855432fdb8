// Elliptical Hertz over Real (double or Batch).
#if defined(OSCULATE_MECHANICS_HERTZ_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_MECHANICS_HERTZ_INL
#undef OSCULATE_MECHANICS_HERTZ_INL
#else
#define OSCULATE_MECHANICS_HERTZ_INL
#endif

#include "mechanics/contact_ellipse-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

template <class Real>
struct HertzState {
  Real force, a_c, b_c, peak_pressure, stiffness, strain_energy;
};

/// From the relative approach at the centre, δ = p_0 b K/Ê, the curvatures, 1/R_i + 1/R_j = 2 p_0 E/(Ê b), and the
/// ellipsoidal pressure, F = 2/3 π p_0 a b. No quotient of vanishing numbers at δ = 0.   [Johnson85 §4.2; KDY23 (1)]
template <class Real>
HWY_INLINE HertzState<Real> hertz_state(const Ellipse<Real>& ellipse, const Real& modulus, const Real& overlap) {
  static constexpr double pi = 3.14159265358979323846;
  const Real depth = max(overlap, Real(0.0));
  const Real twice_radius_E = Real(2.0) * ellipse.R_c * ellipse.E;
  const Real inverse_K = Real(1.0) / ellipse.K;
  HertzState<Real> state;
  state.b_c = sqrt(twice_radius_E * depth * inverse_K);
  state.a_c = state.b_c / ellipse.axis_ratio;
  state.peak_pressure = modulus * state.b_c / twice_radius_E;
  state.stiffness = Real(pi) * modulus * state.a_c * inverse_K;
  state.force = Real(2.0 / 3.0) * state.stiffness * depth;
  state.strain_energy = Real(0.4) * state.force * depth;
  return state;
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
