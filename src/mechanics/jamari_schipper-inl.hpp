// Jamari–Schipper over Real (double or Batch).
#if defined(OSCULATE_MECHANICS_JAMARI_SCHIPPER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_MECHANICS_JAMARI_SCHIPPER_INL
#undef OSCULATE_MECHANICS_JAMARI_SCHIPPER_INL
#else
#define OSCULATE_MECHANICS_JAMARI_SCHIPPER_INL
#endif

#include "mechanics/hertz-inl.hpp"
#include "osculate/mechanics/jamari_schipper.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// Peak pressure at first yield, mean pressure of full plasticity, c_A.
template <class Real>
struct YieldPressures {
  Real yield, plastic, area_ratio;
};

template <class Real>
struct PlasticLimits {
  Real elastic_area, plastic_area;  ///< A_e/δ, A_p/δ
  Real first_yield, span_ratio;     ///< δ_n1, δ_n2/δ_n1
};

template <class Real>
HWY_INLINE PlasticLimits<Real> plastic_limits(const Ellipse<Real>& ellipse, const Real& R_i, const Real& R_j,
                                              const Real& modulus, const YieldPressures<Real>& pressures) {
  static constexpr double pi = 3.14159265358979323846;
  PlasticLimits<Real> limits;
  limits.elastic_area = Real(pi) * beta(ellipse) * ellipse.R_c;
  limits.plastic_area = Real(2.0 * pi) * sqrt(R_i * R_j);
  limits.first_yield = Real(2.0) * ellipse.R_c * ellipse.E * ellipse.K * square(pressures.yield / modulus);
  limits.span_ratio = pressures.area_ratio * limits.elastic_area / limits.plastic_area;
  return limits;
}

template <class Real>
struct JamariSchipperState {
  Real force, area, stiffness, strain_energy, residual_overlap, radius_growth;
  Real largest_overlap, regime;
};

template <class Real>
HWY_INLINE JamariSchipperState<Real> jamari_schipper_state(const Ellipse<Real>& ellipse, const Real& R_i,
                                                           const Real& R_j, const Real& modulus,
                                                           const YieldPressures<Real>& pressures, const Real& overlap,
                                                           const Real& largest_before) {
  using jamari_schipper::Regime;
  const auto code = [](Regime regime) { return Real(static_cast<double>(regime)); };
  const Real zero(0.0), one(1.0), tiny(1e-300);
  const auto limits = plastic_limits(ellipse, R_i, R_j, modulus, pressures);

  // The loading curve at the largest overlap.
  JamariSchipperState<Real> state;
  const Real largest = max(largest_before, max(overlap, zero));
  state.largest_overlap = largest;
  const auto hertz = hertz_state(ellipse, modulus, largest);
  const auto yielded = largest > limits.first_yield;
  const Real progress = largest / limits.first_yield;  // 1 at first yield, span_ratio at full plasticity
  const Real z = min(max((progress - one) / (limits.span_ratio - one), zero), one);
  const Real elastic_area = limits.elastic_area * largest;
  const Real extra_area = limits.plastic_area - limits.elastic_area;
  const Real area = elastic_area + largest * extra_area * (z * z * (Real(3.0) - Real(2.0) * z));
  const Real mean_at_yield = Real(2.0 / 3.0) * pressures.yield;
  const Real growth = (pressures.plastic - mean_at_yield) / log(limits.span_ratio);  // dp/d ln δ
  const Real mean = mean_at_yield + growth * log(min(max(progress, one), limits.span_ratio));
  const Real force = select(yielded, mean * area, hertz.force);
  const auto is_plastic = progress >= limits.span_ratio;
  const Real area_slope = area / max(largest, tiny) + largest * extra_area * (Real(6.0) * z * (one - z)) /
                                                          ((limits.span_ratio - one) * limits.first_yield);
  const Real plastic_slope =
      mean * area_slope + select(is_plastic, zero, growth * area / max(largest, limits.first_yield));

  // What is elastic of it, and where on the elastic curve the contact is now.
  const Real recovery =
      select(yielded, largest * (force / max(hertz.force, tiny)) * sqrt(elastic_area / max(area, tiny)), largest);
  state.residual_overlap = largest - recovery;
  const Real depth = max(recovery - (largest - overlap), zero);
  const Real part = depth / max(recovery, tiny);
  const Real root = sqrt(part);
  state.force = force * part * root;
  state.area = area * part;
  state.strain_energy = Real(0.4) * state.force * depth;
  state.radius_growth = select(yielded, (area / max(elastic_area, tiny)) * largest / max(recovery, tiny), one);
  const auto loading = yielded & (overlap >= largest);
  state.stiffness = select(loading, plastic_slope, Real(1.5) * force * root / max(recovery, tiny));
  state.regime =
      select(depth <= zero, code(Regime::separated),
             select(yielded,
                    select(loading, select(is_plastic, code(Regime::fully_plastic), code(Regime::elastic_plastic)),
                           code(Regime::unloaded)),
                    code(Regime::elastic)));
  return state;
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
