#include "osculate/mechanics/jamari_schipper.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "mechanics/require.hpp"
#include "osculate/core/error.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mechanics/jamari_schipper.cpp"
#include <hwy/foreach_target.h>
// The target list above comes first.
#include "mechanics/jamari_schipper-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// Least c_A: δ_n2 > δ_n1 then holds up to the largest ratio of radii.
inline constexpr double least_area_ratio = 5.0;

void jamari_schipper_contacts(const jamari_schipper::BatchInput& input, const jamari_schipper::BatchOutput& output) {
  using jamari_schipper::Regime;
  const Batch zero(0.0), one(1.0), infinity(std::numeric_limits<double>::infinity());
  const std::size_t size = input.R_i.size();
  for (std::size_t start = 0; start < size; start += lanes<Batch>()) {
    const std::size_t count = std::min(lanes<Batch>(), size - start);
    const Batch R_i = load<Batch>(&input.R_i[start], count), R_j = load<Batch>(&input.R_j[start], count);
    const Batch modulus = load<Batch>(&input.modulus[start], count);
    const YieldPressures<Batch> given{load<Batch>(&input.yield_pressure[start], count),
                                      load<Batch>(&input.plastic_pressure[start], count),
                                      load<Batch>(&input.area_ratio[start], count)};
    const Batch overlap = load<Batch>(&input.overlap[start], count);
    const Batch largest = load<Batch>(&output.largest_overlap[start], count);
    const Mask good = (R_j > zero) & (R_j < infinity) & (R_i >= R_j) & (modulus > zero) & (modulus < infinity) &
                      (given.yield > zero) & (given.plastic >= Batch(2.0 / 3.0) * given.yield) &
                      (given.plastic < infinity) & (given.area_ratio >= Batch(least_area_ratio)) &
                      (given.area_ratio < infinity) & (abs(overlap) < infinity) & (largest >= zero) &
                      (largest < infinity);

    const Batch minor = select(good, R_j, one);
    const Batch major = select(good, limited(R_i, R_j), one);
    const YieldPressures<Batch> pressures{select(good, given.yield, one), select(good, given.plastic, one),
                                          select(good, given.area_ratio, Batch(least_area_ratio))};
    const auto state = jamari_schipper_state(ellipse_of(major, minor), major, minor, select(good, modulus, one),
                                             pressures, select(good, overlap, zero), select(good, largest, zero));

    const auto keep = [&](Batch value) { return select(good, value, zero); };
    store(select(good, state.largest_overlap, largest), &output.largest_overlap[start], count);
    store(keep(state.force), &output.force[start], count);
    store(keep(state.area), &output.area[start], count);
    store(keep(state.stiffness), &output.stiffness[start], count);
    store(keep(state.strain_energy), &output.strain_energy[start], count);
    store(keep(state.residual_overlap), &output.residual_overlap[start], count);
    HWY_ALIGN double codes[lanes<Batch>()];
    store(select(good, state.regime, Batch(static_cast<double>(Regime::bad_input))), codes, lanes<Batch>());
    for (std::size_t i = 0; i < count; ++i) output.regime[start + i] = static_cast<Regime>(static_cast<int>(codes[i]));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace osculate {
HWY_EXPORT(jamari_schipper_contacts);

namespace jamari_schipper {
namespace {

using HWY_NAMESPACE::least_area_ratio;
using Pressures = HWY_NAMESPACE::YieldPressures<double>;

[[noreturn]] void refuse(const std::string& name, double value, const char* expected) {
  throw InputError("jamari_schipper", name + " " + std::to_string(value), expected);
}

void require_positive(const std::string& name, double value, const char* expected) {
  if (!(value > 0.0) || !std::isfinite(value)) refuse(name, value, expected);
}

Pressures pressures_of(const Plasticity& plasticity) {
  return {plasticity.yield_pressure(), plasticity.plastic_pressure(), plasticity.area_ratio};
}

struct Surface {
  HWY_NAMESPACE::Ellipse<double> ellipse;
  double R_i, R_j;
};

Surface surface_of(double R_i, double R_j, double modulus) {
  require_positive("effective modulus", modulus, "a positive, finite value [Pa]");
  const ContactEllipse ellipse = contact_ellipse(R_i, R_j);
  return {{ellipse.R_c, ellipse.axis_ratio, ellipse.e2, ellipse.K, ellipse.E}, HWY_NAMESPACE::limited(R_i, R_j), R_j};
}

/// At x = δ_max/δ_n1: the elastic part u/δ_max, and how much of an increment of load unloading would give back. With
/// F = pA and u ∝ F A^{−1/2}, d(2/5 F u) = F dδ · u (4/5 p'/p + 3/5 A'/A).
struct Recovery {
  double elastic_part, returned;
};

Recovery recovery_at(double x, double pressure_growth, double area_fraction, double span_ratio) {
  const double z = (x - 1.0) / (span_ratio - 1.0);
  const double widening = 1.0 / area_fraction - 1.0;
  const double area = 1.0 + widening * z * z * (3.0 - 2.0 * z);
  const double pressure = 1.0 + pressure_growth * std::log(x);
  const double elastic_part = pressure * std::sqrt(area / x);
  const double area_slope = 1.0 + x * widening * 6.0 * z * (1.0 - z) / ((span_ratio - 1.0) * area);
  return {elastic_part, elastic_part * (0.8 * pressure_growth / pressure + 0.6 * area_slope)};
}

}  // namespace

std::string_view name(Regime regime) {
  switch (regime) {
    case Regime::separated:
      return "separated";
    case Regime::elastic:
      return "elastic";
    case Regime::elastic_plastic:
      return "elastic-plastic";
    case Regime::fully_plastic:
      return "fully plastic";
    case Regime::unloaded:
      return "unloaded";
    case Regime::bad_input:
      return "bad input";
  }
  return "unknown";
}

void validate(const Plasticity& plasticity, double largest_ratio) {
  require_positive("hardness", plasticity.hardness, "a positive, finite value [Pa]");
  require_positive("yield factor K_v", plasticity.yield_factor, "a positive, finite number");
  const double mean_at_yield = 2.0 / 3.0 * plasticity.yield_factor;
  if (!(plasticity.plastic_factor >= mean_at_yield) || !std::isfinite(plasticity.plastic_factor))
    refuse("plastic factor c_h", plasticity.plastic_factor, "a finite number of at least 2/3 of the yield factor K_v");
  if (!(plasticity.area_ratio >= least_area_ratio) || !std::isfinite(plasticity.area_ratio))
    refuse("area ratio c_A", plasticity.area_ratio, "a finite number of at least 5");

  if (!(largest_ratio >= 1.0)) refuse("largest ratio R_i/R_j", largest_ratio, "a number of at least 1");

  constexpr int shapes = 16, steps = 200;
  constexpr double rounding = 1e-12;
  for (int i = 0; i <= shapes; ++i) {
    const double ratio = std::pow(std::min(largest_ratio, largest_radius_ratio), static_cast<double>(i) / shapes);
    const ContactEllipse ellipse = contact_ellipse(std::max(ratio, 1.0), 1.0);
    const double area_fraction = ellipse.beta() * ellipse.R_c / (2.0 * std::sqrt(ratio));
    const double span_ratio = plasticity.area_ratio * area_fraction;
    const double growth = (plasticity.plastic_factor / mean_at_yield - 1.0) / std::log(span_ratio);
    for (int k = 0; k <= steps; ++k) {
      const double x = std::pow(span_ratio, static_cast<double>(k) / steps);
      const Recovery recovery = recovery_at(x, growth, area_fraction, span_ratio);
      if (recovery.returned > 1.0 + rounding || recovery.elastic_part > 1.0 + rounding)
        throw InputError("jamari_schipper",
                         "plastic factor c_h " + std::to_string(plasticity.plastic_factor) + " with K_v " +
                             std::to_string(plasticity.yield_factor) + ", c_A " +
                             std::to_string(plasticity.area_ratio) +
                             " gives back more energy than it took at R_i/R_j = " + std::to_string(ratio),
                         "a smaller c_h or a larger c_A");
    }
  }
}

Limits limits(double R_i, double R_j, double modulus, const Plasticity& plasticity) {
  const Surface surface = surface_of(R_i, R_j, modulus);
  const auto found =
      HWY_NAMESPACE::plastic_limits(surface.ellipse, surface.R_i, surface.R_j, modulus, pressures_of(plasticity));
  return {.first_yield = found.first_yield, .full_plasticity = found.first_yield * found.span_ratio};
}

Contact contact(double R_i, double R_j, double modulus, const Plasticity& plasticity, double overlap, Memory& memory) {
  const Surface surface = surface_of(R_i, R_j, modulus);
  if (!std::isfinite(overlap)) refuse("overlap", overlap, "a finite value [m]");
  if (!(memory.largest_overlap >= 0.0) || !std::isfinite(memory.largest_overlap))
    refuse("largest overlap", memory.largest_overlap, "a finite value of at least 0 [m]");
  const auto state = HWY_NAMESPACE::jamari_schipper_state(surface.ellipse, surface.R_i, surface.R_j, modulus,
                                                          pressures_of(plasticity), overlap, memory.largest_overlap);
  memory.largest_overlap = state.largest_overlap;
  return {.force = state.force,
          .area = state.area,
          .stiffness = state.stiffness,
          .strain_energy = state.strain_energy,
          .residual_overlap = state.residual_overlap,
          .radius_growth = state.radius_growth,
          .regime = static_cast<Regime>(static_cast<int>(state.regime))};
}

void contacts(const BatchInput& input, const BatchOutput& output) {
  const std::size_t size = input.R_i.size();
  require_columns("jamari_schipper::contacts", size,
                  {input.R_j.size(), input.modulus.size(), input.yield_pressure.size(), input.plastic_pressure.size(),
                   input.area_ratio.size(), input.overlap.size(), output.largest_overlap.size(), output.force.size(),
                   output.area.size(), output.stiffness.size(), output.strain_energy.size(),
                   output.residual_overlap.size(), output.regime.size()});
  HWY_DYNAMIC_DISPATCH(jamari_schipper_contacts)(input, output);
}

}  // namespace jamari_schipper
}  // namespace osculate
#endif
