// Fig. 8: collisions that lose energy to viscosity, to adhesion and to plastic flow.

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "osculate/mechanics/brilliantov.hpp"
#include "osculate/mechanics/damped_hertz.hpp"
#include "osculate/mechanics/jamari_schipper.hpp"
#include "osculate/mechanics/material.hpp"
#include "validation/kildashti2023/figures.hpp"
#include "validation/kildashti2023/figures/curves.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

// Two equal spheres of 50 µm, glass.
constexpr double sphere_radius = 50e-6, density = 2500.0, dissipative_time = 5e-9, work_of_adhesion = 0.1;
const double modulus = effective_modulus({70e9, 0.22}, {70e9, 0.22});
const double sphere_mass = 4.0 / 3.0 * std::numbers::pi * density * std::pow(sphere_radius, 3);
const ImpactPair pair = sphere_pair(sphere_radius, sphere_mass, sphere_radius, sphere_mass, modulus);
const jamari_schipper::Plasticity plasticity{
    .hardness = 6e9, .yield_factor = 0.6, .plastic_factor = 0.6, .area_ratio = 160.0};

/// One collision from touch to parting: what `force(overlap, rate)` makes of two bodies that meet at `speed`; it
/// returns nothing where the contact is open. Velocity Verlet.
struct Collision {
  io::Curve curve;
  double restitution;  ///< 0: they stick
};

template <class Force>
Collision collide(double speed, const Force& force) {
  constexpr int steps_a_collision = 1500;
  const double step = hertz_impact::impact(pair, speed).duration / steps_a_collision;
  Collision collision{.curve = {.name = {}, .x = {}, .y = {}}, .restitution = 0.0};
  double overlap = 0.0, rate = speed;
  for (int i = 0; i < 20 * steps_a_collision; ++i) {
    const std::optional<double> now = force(overlap, rate);
    if (!now) {
      collision.restitution = rate < 0.0 ? -rate / speed : 0.0;
      return collision;
    }
    collision.curve.x.push_back(1e9 * overlap);
    collision.curve.y.push_back(1e6 * *now);
    const double half_rate = rate - 0.5 * step * *now / pair.mass;
    overlap += step * half_rate;
    const std::optional<double> next = force(overlap, half_rate);
    rate = half_rate - 0.5 * step * next.value_or(0.0) / pair.mass;
  }
  return collision;  // still in contact after many durations
}

/// Every fifth point of a curve is enough for a picture.
io::Curve thinned(const io::Curve& curve, std::string name) {
  io::Curve thin{.name = std::move(name), .x = {}, .y = {}};
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (i % 5 != 0 && i + 1 != curve.x.size()) continue;
    thin.x.push_back(curve.x[i]);
    thin.y.push_back(curve.y[i]);
  }
  return thin;
}

std::optional<double> viscous_force(double overlap, double rate) {
  static const damped_hertz::Model model = damped_hertz::brilliantov(pair, dissipative_time);
  if (overlap < 0.0) return std::nullopt;
  return damped_hertz::force(model, overlap, rate, Attraction::cut_off);
}

std::optional<double> adhesive_force(double overlap, double rate) {
  const johnson_greenwood::Pair adhesive{
      .R_i = pair.radius, .R_j = pair.radius, .modulus = modulus, .work_of_adhesion = work_of_adhesion};
  const auto state = johnson_greenwood::at_overlap(adhesive, overlap);
  if (!state) return std::nullopt;
  return state->force + brilliantov::dissipative_force(dissipative_time, *state, rate);
}

/// Restitution of an impact on a yielding contact: the energy that unloading gives back over that of loading.
double plastic_restitution(double speed) {
  jamari_schipper::Memory memory;
  const double energy = 0.5 * pair.mass * speed * speed;
  const double step = 1e-3 * hertz_impact::impact(pair, speed).largest_overlap;
  double work = 0.0, before = 0.0;
  for (int i = 1;; ++i) {
    const auto contact = jamari_schipper::contact(pair.radius, pair.radius, modulus, plasticity, step * i, memory);
    work += 0.5 * step * (before + contact.force);
    before = contact.force;
    if (work >= energy) return std::sqrt(contact.strain_energy / work);
  }
}

io::Panel plastic_loops() {
  const auto limits = jamari_schipper::limits(pair.radius, pair.radius, modulus, plasticity);
  io::Panel panel{.title = "Elastic–plastic contact, loaded and unloaded",
                  .x = {.label = "overlap δ/δ_{n1}"},
                  .y = {.label = "force F/F(δ_{n1})"},
                  .curves = {}};
  jamari_schipper::Memory fresh;
  const double unit =
      jamari_schipper::contact(pair.radius, pair.radius, modulus, plasticity, limits.first_yield, fresh).force;
  const double deepest = 160.0;
  const auto force = [&](jamari_schipper::Memory& memory) {
    return [&](double overlap) {
      return jamari_schipper::contact(pair.radius, pair.radius, modulus, plasticity, overlap * limits.first_yield,
                                      memory)
                 .force /
             unit;
    };
  };
  jamari_schipper::Memory loading;
  panel.curves.push_back(curve("loading", evenly(0.0, deepest, 161), force(loading)));
  panel.curves.push_back(curve(
      "Hertz", evenly(0.0, 65.0, 66), [](double overlap) { return std::pow(overlap, 1.5); }, io::Mark::dotted));
  bool first = true;
  for (const double peak : {40.0, 80.0, 160.0}) {
    jamari_schipper::Memory memory{.largest_overlap = peak * limits.first_yield};
    const double residual =
        jamari_schipper::contact(pair.radius, pair.radius, modulus, plasticity, memory.largest_overlap, memory)
            .residual_overlap /
        limits.first_yield;
    panel.curves.push_back(
        curve(first ? "unloading, reloading" : "", evenly(peak, residual, 81), force(memory), io::Mark::dashed));
    panel.curves.back().colour = io::palette::red;
    first = false;
  }
  return panel;
}

}  // namespace

Figure figure8() {
  const auto speeds = by_factors(3e-3, 30.0, 41);
  Figure figure;
  figure.caption = fmt::format(
      "Head-on collisions of two glass spheres of 50 µm. Viscous: (37) with A = {:g} ns; with adhesion: (39) set "
      "right, "
      "W = {:g} J/m². Elastic–plastic: Jamari and Schipper (41)–(46) with unloading, H = 6 GPa, K_v = c_h = 0.6, c_A = "
      "160; δ_n1 is the overlap of first yield. Restitution: viscous by integration and by its series, with adhesion "
      "by "
      "integration (0: the spheres stick), plastic by the energy that unloading gives back. Inferred: all but the "
      "equations; bodies and materials were chosen here.",
      dissipative_time * 1e9, work_of_adhesion);
  io::Panel loops{.title = "Collisions at 2 cm/s",
                  .x = {.label = "overlap δ [nm]"},
                  .y = {.label = "force F [µN]"},
                  .curves = {thinned(collide(0.02, viscous_force).curve, "viscous (37)"),
                             thinned(collide(0.02, adhesive_force).curve, "viscous, with adhesion (39)")}};
  io::Panel restitution{
      .title = "Restitution",
      .x = {.label = "speed of impact v [m/s]", .scale = io::Scale::logarithmic},
      .y = {.label = "coefficient of restitution", .range = io::PlotRange{0.0, 1.05}},
      .curves = {curve("viscous (37)", speeds,
                       [](double speed) {
                         static const damped_hertz::Model model = damped_hertz::brilliantov(pair, dissipative_time);
                         return damped_hertz::impact(model, pair.mass, speed, Attraction::cut_off).restitution;
                       }),
                 curve(
                     "its series", speeds,
                     [](double speed) {
                       return brilliantov::restitution(dissipative_time, pair.hertz_coefficient(), pair.mass, speed);
                     },
                     io::Mark::points),
                 curve("viscous, with adhesion (39)", by_factors(3e-3, 30.0, 81),
                       [](double speed) { return collide(speed, adhesive_force).restitution; })}};
  io::Panel plastic{.title = "Restitution of elastic–plastic impacts",
                    .x = {.label = "speed of impact v [m/s]", .scale = io::Scale::logarithmic},
                    .y = {.label = "coefficient of restitution", .range = io::PlotRange{0.0, 1.05}},
                    .curves = {curve("", by_factors(0.1, 300.0, 61), plastic_restitution)}};
  figure.plot = {.title = "Fig. 8   Collisions that lose energy",
                 .panels = {loops, restitution, plastic_loops(), plastic}};
  return figure;
}

}  // namespace osculate::validation::kildashti2023
