// Elliptical JKR over Real (double or Batch).
#if defined(OSCULATE_MECHANICS_JOHNSON_GREENWOOD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_MECHANICS_JOHNSON_GREENWOOD_INL
#undef OSCULATE_MECHANICS_JOHNSON_GREENWOOD_INL
#else
#define OSCULATE_MECHANICS_JOHNSON_GREENWOOD_INL
#endif

#include "mechanics/contact_ellipse-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// A pair's radii as the theory needs them; R_i/R_j ≤ largest_radius_ratio.
template <class Real>
struct RadiiOfContact {
  Real R;          // (R_i R_j)^{1/2}
  Real ratio;      // R_j/R_i
  Real deviation;  // 1 − ratio, exact
  Real lambda;     // ratio^{1/2}
};
template <class Real>
HWY_INLINE RadiiOfContact<Real> radii_of_contact(const Real& R_i, const Real& R_j) {
  const Real inverse = Real(1.0) / R_i;
  const Real ratio = R_j * inverse;
  const Real lambda = sqrt(ratio);
  return {lambda * R_i, ratio, (R_i - R_j) * inverse, lambda};
}

/// A value with its derivatives by x = ln g and y = ln a.
template <class Real>
struct Slope {
  Real value, by_x, by_y;
};

/// The pressure's constants for an ellipse of axis ratio g, in units of Ê a/R: p_1 = Π_1/(2g), p_2 = p_1 + difference.
/// From u_z of the traction: a λ/(2gR) = (D + C) p_1 − C p_2 and g/(2λ) = (B + g²C) p_2 − g²C p_1 times the unit. Their
/// difference is written so that it vanishes exactly at Hertz's g.
template <class Real>
struct PressureConstants {
  EllipticIntegrals<Real> integrals;
  Real root_g;
  Real p_1, difference;
  Real p_1_by_x, difference_by_x;
  Real D_by_x;
};
template <class Real>
HWY_INLINE PressureConstants<Real> pressure_constants(const RadiiOfContact<Real>& radii, const Real& g) {
  static constexpr double C_by_m_at_circle = 0.14726215563702155;  // 3π/64
  const Real one(1.0), two(2.0), half(0.5);
  const Real m1 = g * g, m = (one - g) * (one + g);
  const auto integrals = elliptic_integrals(m, m1, Real(-2.0) * log(g));
  const auto& [K, E, B, C, D] = integrals;
  const Real B_by_x = -m1 * C, D_by_x = C - D;
  const Real near_circle = m1 * Real(-2.0 * C_by_m_at_circle);
  const Real C_by_x = select(m < Real(1e-5), near_circle, (C * (one + Real(3.0) * m1) - D) / max(m, Real(1e-5)));

  const Real sum = B * (C + D), product = m1 * C * D, determinant = sum + product;
  const Real determinant_by_x =
      B_by_x * (C + D) + B * (C_by_x + D_by_x) + two * product + m1 * (C_by_x * D + C * D_by_x);
  const Real scale = half / (g * radii.lambda * determinant);
  const Real scale_by_x = -one - determinant_by_x / determinant;  // of its logarithm

  PressureConstants<Real> result;
  result.integrals = integrals;
  result.root_g = sqrt(g);
  result.p_1 = scale * fma(radii.ratio, fma(m1, C, B), m1 * C);
  result.p_1_by_x = fma(result.p_1, scale_by_x, scale * m1 * (radii.ratio * (C + C_by_x) + two * C + C_by_x));
  const Real mismatch = select(m < half, radii.deviation * B - m * (D - C), m1 * D - radii.ratio * B);
  result.difference = scale * mismatch;
  result.difference_by_x = fma(result.difference, scale_by_x, scale * m1 * (D + C + radii.ratio * C));
  result.D_by_x = D_by_x;
  return result;
}

/// The factors of δ = g a²/R · depth and F = 2π/3 g Ê a³/R · load, given the tension T at the edge in the unit of p_1.
template <class Real>
HWY_INLINE Real depth_factor(const PressureConstants<Real>& p, const Real& T) {
  const auto& [K, E, B, C, D] = p.integrals;
  return K * p.p_1 - T * (Real(2.0) * K + D * (Real(1.0) / p.root_g - Real(1.0)));
}
template <class Real>
HWY_INLINE Real load_factor(const PressureConstants<Real>& p, const Real& T) {
  return p.p_1 - T * (Real(2.0) + Real(1.0) / p.root_g);
}

/// A pair: its radii, Ê, the tension's scale S (T = S a^{-3/2}) and Hertz's axis ratio.
template <class Real>
struct AdhesivePair {
  RadiiOfContact<Real> radii;
  Real modulus;
  Real strength;  // (2W/(π Ê))^{1/2} R
  Real length;    // strength^{2/3}
  Ellipse<Real> hertz;
};
template <class Real>
HWY_INLINE AdhesivePair<Real> adhesive_pair(const Real& R_i, const Real& R_j, const Real& modulus, const Real& work) {
  static constexpr double two_over_pi = 0.6366197723675814;
  AdhesivePair<Real> pair;
  pair.radii = radii_of_contact(R_i, R_j);
  pair.modulus = modulus;
  pair.strength = sqrt(Real(two_over_pi) * work / modulus) * pair.radii.R;
  // Only a start for the search, so an exponent is enough; the bound keeps log from zero.
  pair.length = select(work > Real(0.0), exp(Real(2.0 / 3.0) * log(max(pair.strength, Real(1e-200)))), Real(0.0));
  pair.hertz = ellipse_of(R_i, R_j);
  return pair;
}

/// Where (a, g) stands: `edge` = 0 makes the tension Griffith's at both axes' ends, that is equilibrium.
template <class Real>
struct CurvePoint {
  Slope<Real> edge, overlap, force;
};
template <class Real>
HWY_INLINE CurvePoint<Real> curve_point(const AdhesivePair<Real>& pair, const Real& a, const Real& g) {
  static constexpr double two_thirds_pi = 2.0943951023931953;
  const Real half(0.5), one(1.0), two(2.0), three(3.0), three_halves(1.5);
  const auto p = pressure_constants(pair.radii, g);
  const auto& [K, E, B, C, D] = p.integrals;
  const Real T = pair.strength / (a * sqrt(a)), inverse_root = one / p.root_g;
  const Real gap = (one - g) / (one + p.root_g);  // 1 − √g

  CurvePoint<Real> point;
  point.edge.value = p.root_g * p.difference - T * gap;
  point.edge.by_x = p.root_g * (half * p.difference + p.difference_by_x + half * T);
  point.edge.by_y = three_halves * T * gap;

  const Real depth_unit = g * a * a / pair.radii.R, depth = depth_factor(p, T);
  const Real depth_by_x =
      K * p.p_1_by_x - B * p.p_1 - T * (p.D_by_x * (inverse_root - one) - two * B - half * D * inverse_root);
  point.overlap.value = depth_unit * depth;
  point.overlap.by_x = depth_unit * (depth + depth_by_x);
  point.overlap.by_y = depth_unit * (two * depth + three_halves * (K * p.p_1 - depth));

  const Real load_unit = Real(two_thirds_pi) * pair.modulus * a * depth_unit, load = load_factor(p, T);
  point.force.value = load_unit * load;
  point.force.by_x = load_unit * (load + p.p_1_by_x + half * T * inverse_root);
  point.force.by_y = load_unit * (three * load + three_halves * (p.p_1 - load));
  return point;
}

/// Derivative by ln a along the equilibrium curve.
template <class Real>
HWY_INLINE Real along_curve(const CurvePoint<Real>& point, const Slope<Real>& quantity) {
  return quantity.by_y - quantity.by_x * point.edge.by_y / point.edge.by_x;
}

/// What is prescribed.
struct OverlapControl {
  template <class Real>
  static HWY_INLINE const Slope<Real>& quantity(const CurvePoint<Real>& point) {
    return point.overlap;
  }
};
struct ForceControl {
  template <class Real>
  static HWY_INLINE const Slope<Real>& quantity(const CurvePoint<Real>& point) {
    return point.force;
  }
};

template <class Real>
struct CurveSearch {
  Real a, g;
  Real force, overlap, stiffness;
  MaskType<Real> found;      // equilibrium at the target, on the stable branch
  MaskType<Real> abandoned;  // the target lies beyond the fold: the contact has parted
};

template <class Real>
HWY_INLINE CurveSearch<Real> select(const MaskType<Real>& condition, const CurveSearch<Real>& yes,
                                    const CurveSearch<Real>& no) {
  return {select(condition, yes.a, no.a),
          select(condition, yes.g, no.g),
          select(condition, yes.force, no.force),
          select(condition, yes.overlap, no.overlap),
          select(condition, yes.stiffness, no.stiffness),
          select(condition, yes.found, no.found),
          select(condition, yes.abandoned, no.abandoned)};
}

/// e^x to the second order, for steps of |x| ≤ 1 in a logarithm.
template <class Real>
HWY_INLINE Real exponential(const Real& x) {
  const Real half_step = Real(0.5) * x;
  return (Real(1.0) + half_step) / (Real(1.0) - half_step);
}

/// Newton's method in (ln a, ln g) for the stable equilibrium with the prescribed quantity. Along the curve it is a
/// convex function of ln a, so that from the right of the root the steps stay right of it, and past the fold (its
/// minimum) they cross to where it falls: a contact that does so three times in spite of being put back has no root.
/// Far from the curve the slope along it means nothing; there only g moves.
template <class Control, class Real>
HWY_INLINE CurveSearch<Real> search_curve(const AdhesivePair<Real>& pair, const Real& target, const Real& a_start,
                                          const Real& g_start, const MaskType<Real>& wanted) {
  constexpr int most_steps = 60, most_crossings = 3;
  constexpr double near_curve = 0.1;
  constexpr double converged = 1e-8;  // of the last step; the error left is its square
  const Real zero(0.0), one(1.0), half(0.5);
  CurveSearch<Real> result{a_start, g_start, zero, zero, zero, !(wanted | !wanted), !(wanted | !wanted)};
  Real crossings = zero;
  for (int step = 0; step < most_steps; ++step) {
    const auto active = wanted & !(result.found | result.abandoned);
    if (!any(active)) break;
    const auto point = curve_point(pair, result.a, result.g);
    const Slope<Real> quantity = Control::quantity(point);
    const Real rise = along_curve(point, quantity);
    const Real off_curve = point.edge.value / point.edge.by_x, by_y = point.edge.by_y / point.edge.by_x;
    const auto on_curve = abs(off_curve) < Real(near_curve);
    const auto rising = rise > zero;

    // The step to the target; where the curve falls, a step to the right.
    const Real newton = (target - quantity.value + quantity.by_x * off_curve) / select(rising, rise, one);
    const Real dy = select(on_curve, min(max(select(rising, newton, half), -one), one), zero);
    const Real dx = min(max(-off_curve - by_y * dy, -one), one);
    const Real a = result.a * exponential(dy);
    const Real g = min(max(result.g * exponential(dx), pair.hertz.axis_ratio), one);

    const auto close = active & on_curve & rising & (abs(dy) + abs(dx) < Real(converged));
    const Real force = point.force.value + point.force.by_x * dx + point.force.by_y * dy;
    const Real overlap = point.overlap.value + point.overlap.by_x * dx + point.overlap.by_y * dy;
    const Real stiffness = along_curve(point, point.force) / along_curve(point, point.overlap);
    result.force = select(active, force, result.force);
    result.overlap = select(active, overlap, result.overlap);
    result.stiffness = select(active, stiffness, result.stiffness);
    result.a = select(active, a, result.a);
    result.g = select(active, g, result.g);
    crossings = crossings + select(on_curve & !rising, one, zero);
    result.found = result.found | close;
    result.abandoned = result.abandoned | (active & (crossings >= Real(most_crossings)));
  }
  return result;
}

/// g on the equilibrium curve near a given tension; exact for nearly circular contacts, a start for others.
template <class Real>
HWY_INLINE Real axis_ratio_guess(const AdhesivePair<Real>& pair, const Real& a) {
  static constexpr double quarter_pi = 0.7853981633974483;
  const Real T = pair.strength / (a * sqrt(a));
  return exp(log(pair.hertz.axis_ratio) / (Real(1.0) + Real(quarter_pi) * T));
}

/// A major semi-axis to the right of the root: Hertz's, and a circular contact's at δ = 0 on top.
template <class Real>
HWY_INLINE Real major_axis_guess(const AdhesivePair<Real>& pair, const Real& overlap) {
  const Real depth = max(overlap, Real(0.0));
  const Real a_hertz = sqrt(Real(2.0) * pair.hertz.R_c * pair.hertz.E * depth / pair.hertz.K) / pair.hertz.axis_ratio;
  return a_hertz + Real(2.2) * pair.length;
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
