// Fig. 12: tangential loading at a constant normal force, in directions between the axes of the ellipse.

#include <fmt/core.h>

#include <array>
#include <numbers>

#include "osculate/mechanics/mindlin.hpp"
#include "validation/kildashti2023/cases.hpp"
#include "validation/kildashti2023/figures.hpp"
#include "validation/kildashti2023/figures/curves.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

constexpr ElasticMaterial material{.youngs_modulus = 1.0, .poissons_ratio = 0.3};
constexpr std::array<double, 3> angles{0.0, 45.0, 90.0};  // from the major axis [degrees]
constexpr std::array<io::Colour, 3> colours{io::palette::blue, io::palette::orange, io::palette::green};

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

/// Compliance along a direction of the ellipse of R_i/R_j, a_c = 1.
double compliance_along(double ratio, double degrees) {
  const mindlin::Axes axes = mindlin::compliance(contact_ellipse(ratio, 1.0), 1.0, material, material);
  return mindlin::off_axis(axes, radians(degrees)).along;
}

/// A contact of case 1 in which μF_n = 1 and along the major axis everything slides at a displacement of 1.
mindlin::Contact contact_of_case_1(double degrees) {
  const double ratio = cases[0].R_i.value / cases[0].R_j.value;
  return mindlin::contact(2.0 / 3.0 * compliance_along(ratio, degrees) / compliance_along(ratio, 0.0), 1.0, 1.0);
}

/// Displacement over force along a path: virgin loading to the peak, then to −peak and back.
io::Curve loop(const mindlin::Contact& contact, double peak, std::string name, const io::Colour& colour) {
  io::Curve curve{.name = std::move(name), .x = {}, .y = {}, .mark = io::Mark::line, .colour = colour};
  const auto follow = [&](double from, double to, const auto& displacement) {
    for (const double force : evenly(from, to, 81)) {
      curve.x.push_back(displacement(force));
      curve.y.push_back(force);
    }
  };
  follow(0.0, peak, [&](double force) { return mindlin::displacement(contact, force); });
  follow(peak, -peak, [&](double force) { return mindlin::unloading_displacement(contact, force, peak); });
  follow(-peak, peak, [&](double force) { return mindlin::reloading_displacement(contact, force, peak); });
  return curve;
}

}  // namespace

Figure figure12() {
  const io::Axis displacement{.label = "displacement δ_{t}/(sliding displacement at θ = 0)"};
  const io::Axis force{.label = "force F_{t}/(μF_{n})"};
  io::Panel directions{.title = "Loops along the direction θ", .x = displacement, .y = force, .curves = {}};
  io::Panel peaks{.title = "Loops of different peaks, θ = 0", .x = displacement, .y = force, .curves = {}};
  io::Panel energies{.title = "Energy lost in a loop",
                     .x = {.label = "peak F_{t}*/(μF_{n})", .scale = io::Scale::logarithmic},
                     .y = {.label = "ΔE/(μF_{n} sliding displacement)", .scale = io::Scale::logarithmic},
                     .curves = {}};
  const auto amplitudes = by_factors(0.05, 0.999, 201);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const mindlin::Contact contact = contact_of_case_1(angles[i]);
    const std::string name = fmt::format("θ = {:g}°", angles[i]);
    directions.curves.push_back(loop(contact, 0.9, name, colours[i]));
    peaks.curves.push_back(loop(contact_of_case_1(0.0), std::array{0.95, 0.7, 0.4}[i],
                                fmt::format("F_{{t}}* = {:g} μF_{{n}}", std::array{0.95, 0.7, 0.4}[i]), colours[i]));
    energies.curves.push_back(
        curve(name, amplitudes, [&](double peak) { return mindlin::cycle_energy(contact, peak); }));
    energies.curves.back().colour = colours[i];
  }
  energies.curves.push_back(curve(
      "θ = 0°, small peaks (76)", amplitudes,
      [](double peak) { return mindlin::small_cycle_energy(contact_of_case_1(0.0), peak); }, io::Mark::dotted));
  io::Panel compliances{.title = "Compliance without slip",
                        .x = {.label = "direction θ from the major axis [°]"},
                        .y = {.label = "compliance over that of a circle of a_{c}"},
                        .curves = {}};
  for (const double ratio : {1.0, 2.0, 5.0, 44.0}) {
    compliances.curves.push_back(
        curve(fmt::format("R_{{i}}/R_{{j}} = {:g}", ratio), evenly(0.0, 90.0, 46),
              [&](double angle) { return compliance_along(ratio, angle) / compliance_along(1.0, 0.0); }));
  }
  Figure figure;
  figure.caption =
      "Cattaneo–Mindlin–Deresiewicz at a constant normal force (56)–(69), (76): force against the total relative "
      "displacement along the force, in the ellipse of case 1, ν = 0.3; θ = 0 is the major axis. Unit of displacement: "
      "where "
      "everything slides at θ = 0. Inferred: that loops are drawn for several θ; peaks, case and ν were chosen here.";
  figure.plot = {.title = "Fig. 12   Tangential force at a constant normal force",
                 .panels = {directions, peaks, energies, compliances}};
  return figure;
}

}  // namespace osculate::validation::kildashti2023
