// Contacts that yield.

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "mechanics/laws/elastic.hpp"
#include "mechanics/laws/laws.hpp"
#include "osculate/mechanics/hertz.hpp"
#include "osculate/mechanics/jamari_schipper.hpp"

namespace osculate::laws {
namespace {

constexpr auto excluded = LawParameter::Bound::excluded;
constexpr std::array parameters{
    LawParameter{.name = "hardness",
                 .symbol = "H",
                 .unit = "Pa",
                 .meaning = "hardness of the softer body",
                 .least = 0.0,
                 .least_bound = excluded},
    LawParameter{.name = "yield_factor",
                 .symbol = "K_v",
                 .unit = "",
                 .meaning = "peak pressure at first yield over H",
                 .least = 0.0,
                 .least_bound = excluded},
    LawParameter{.name = "plastic_factor",
                 .symbol = "c_h",
                 .unit = "",
                 .meaning = "mean pressure of fully plastic contact over H, at least 2/3 K_v",
                 .least = 0.0,
                 .least_bound = excluded},
    LawParameter{.name = "area_ratio",
                 .symbol = "c_A",
                 .unit = "",
                 .meaning = "area at full plasticity over that at first yield",
                 .least = 5.0},
    LawParameter{.name = "largest_radius_ratio",
                 .symbol = "R_i/R_j",
                 .unit = "",
                 .meaning = "up to which it is proved at set-up that no energy is created",
                 .least = 1.0,
                 .standard = 1e3}};
constexpr std::array<std::string_view, 1> elliptical{"hertz"};
constexpr std::array conflicts{LawConflict{"normal", "its elastic contact is the elliptical one of hertz", elliptical}};

/// What loading from one largest overlap to the next takes beyond what unloading gives back: Simpson's rule on the
/// loading curve between `lowest` and `highest`, where it is smooth.
template <class Loading>
double flow_loss(const Loading& loading, double lowest, double highest, double from, double to) {
  const double start = std::max(from, lowest), end = std::min(to, highest);
  if (!(end > start)) return 0.0;
  const auto at_start = loading(start), at_end = loading(end);
  const double middle = loading(0.5 * (start + end)).force;
  return (end - start) / 6.0 * (at_start.force + 4.0 * middle + at_end.force) -
         (at_end.strain_energy - at_start.strain_energy);
}

/// One column a quantity, for up to `stretch` contacts.
using Column = std::array<double, stretch>;

/// The energy that went into flow while the largest overlap grew from `before` to `now`.
double flow_loss(const Contact& contact, double modulus, const jamari_schipper::Plasticity& plasticity, double before,
                 double now) {
  if (!(now > before)) return 0.0;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto limits = jamari_schipper::limits(contact.R_i, contact.R_j, modulus, plasticity);
  const auto loading = [&](double overlap) {
    jamari_schipper::Memory virgin;
    return jamari_schipper::contact(contact.R_i, contact.R_j, modulus, plasticity, overlap, virgin);
  };
  return flow_loss(loading, limits.first_yield, limits.full_plasticity, before, now) +
         flow_loss(loading, limits.full_plasticity, infinity, before, now);
}

Part bind(const Binding& binding) {
  const double modulus = effective_modulus(binding.material_1, binding.material_2);
  const jamari_schipper::Plasticity plasticity{.hardness = binding["hardness"],
                                               .yield_factor = binding["yield_factor"],
                                               .plastic_factor = binding["plastic_factor"],
                                               .area_ratio = binding["area_ratio"]};
  jamari_schipper::validate(plasticity, binding["largest_radius_ratio"]);
  return {.step = [modulus, plasticity](std::span<Contact> contacts, std::span<const Memory> memories) {
    Column R_i, R_j, moduli, yield, plastic, ratio, overlap, largest, force, area, stiffness, energy, residual;
    Column any_overlap, any, a, b;
    std::array<jamari_schipper::Regime, stretch> regime;
    std::array<hertz::Validity, stretch> validity;
    const std::size_t count = contacts.size();
    for (std::size_t i = 0; i < count; ++i) {
      R_i[i] = contacts[i].R_i, R_j[i] = contacts[i].R_j, overlap[i] = contacts[i].overlap;
      moduli[i] = modulus, yield[i] = plasticity.yield_pressure(), plastic[i] = plasticity.plastic_pressure();
      ratio[i] = plasticity.area_ratio;
      largest[i] = memories[i][0];
      any_overlap[i] = R_j[i];
    }
    const auto in = [count](const Column& column) { return std::span(column).first(count); };
    const auto out = [count](Column& column) { return std::span(column).first(count); };
    jamari_schipper::contacts({in(R_i), in(R_j), in(moduli), in(yield), in(plastic), in(ratio), in(overlap)},
                              {out(largest), out(force), out(area), out(stiffness), out(energy), out(residual),
                               std::span(regime).first(count)});
    // The ellipse keeps its shape, whatever the load.
    hertz::contacts({in(R_i), in(R_j), in(R_j), in(moduli), in(any_overlap)},
                    {out(any), out(a), out(b), out(any), out(any), out(any), std::span(validity).first(count)});
    for (std::size_t i = 0; i < count; ++i) {
      Contact& contact = contacts[i];
      contact.closed = contact.overlap > 0.0;
      if (!contact.closed) {
        memories[i][0] = 0.0;
        continue;
      }
      contact.axis_ratio = b[i] / a[i];
      contact.a_c = std::sqrt(area[i] / (std::numbers::pi * contact.axis_ratio));
      contact.elastic = contact.friction_load = force[i];
      contact.stiffness = stiffness[i];
      contact.stored_normal = energy[i];
      contact.hysteresis_loss += flow_loss(contact, modulus, plasticity, memories[i][0], largest[i]);
      memories[i][0] = largest[i];
    }
  }};
}

}  // namespace

const Law jamari_schipper{{.name = "jamari_schipper",
                           .slot = LawSlot::plasticity,
                           .title = "Elastic, elastic-plastic and plastic, with unloading",
                           .formula = "F = p(δ) A(δ) on loading, Hertz on flattened surfaces below the largest overlap",
                           .equations = "(41)-(46)",
                           .source = "JS06, JS06b",
                           .parameters = parameters,
                           .memory = 1,
                           .conflicts = conflicts},
                          bind};

}  // namespace osculate::laws
