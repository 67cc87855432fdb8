// Fig. 7: rough contacts at a prescribed separation, elastic and with asperities that yield.

#include <fmt/core.h>

#include <cmath>

#include "osculate/mechanics/greenwood_williamson.hpp"
#include "osculate/mechanics/jeng_wang.hpp"
#include "osculate/mechanics/material.hpp"
#include "validation/kildashti2023/figures.hpp"
#include "validation/kildashti2023/figures/curves.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

// Machined steel: χ β σ = 0.05, σ/β = 0.005.
const double modulus = effective_modulus({210e9, 0.3}, {210e9, 0.3});
constexpr greenwood_williamson::Roughness rough{.density = 2.5e8, .radius = 200e-6, .deviation = 1e-6};
constexpr double nominal_area = 1e-6;

jeng_wang::Surface surface(double hardness) {
  return {.density = rough.density,
          .R_i = rough.radius,
          .R_j = rough.radius,
          .deviation = rough.deviation,
          .modulus = modulus,
          .hardness = hardness};
}

/// F_{3/2} by the modified Bessel functions of (35), h > 0.
double bessel_form(double h) {
  const double x = 0.25 * h * h;
  return std::exp(-x) * std::sqrt(h) / (4.0 * std::sqrt(M_PI)) *
         ((h * h + 1.0) * std::cyl_bessel_k(0.25, x) - h * h * std::cyl_bessel_k(0.75, x));
}

double pressure_in_MPa(double force) {
  return 1e-6 * force / nominal_area;
}

}  // namespace

Figure figure7() {
  const auto all = evenly(-2.0, 4.0, 121), positive = evenly(0.05, 4.0, 40), apart = evenly(-1.0, 4.0, 101);
  const io::Axis separation{.label = "separation h = d/σ"};
  const auto elastic = [](double h) { return greenwood_williamson::patch_at(rough, modulus, nominal_area, h); };
  const auto yielding = [](double hardness) {
    return [hardness](double h) { return jeng_wang::patch_at(surface(hardness), nominal_area, h); };
  };
  const auto soft = yielding(1.5e9), hard = yielding(6e9);

  Figure figure;
  figure.caption = fmt::format(
      "Rough contact of Greenwood and Williamson (29)–(36) at a prescribed separation, and of elastic–plastic "
      "asperities "
      "after Jeng and Wang (47)–(53). Steel on steel, Ê = {:.1f} GPa, χ = 2.5·10⁸ m⁻², asperity radius 200 µm, σ = 1 "
      "µm; "
      "hardness as given. Inferred: that force and area are drawn over h; surface and hardness were chosen here.",
      modulus * 1e-9);
  io::Panel integrals{.title = "Height integrals, any h",
                      .x = separation,
                      .y = {.label = "F_{n}(h)", .scale = io::Scale::logarithmic},
                      .curves = {}};
  integrals.curves.push_back(curve("F_{3/2}, force: integral", all,
                                   [](double h) { return greenwood_williamson::height_integrals(h).three_halves; }));
  integrals.curves.push_back(curve("F_{3/2} by (35), h > 0", positive, bessel_form, io::Mark::points));
  integrals.curves.push_back(curve("F_{1}, area: (36) set right", all, greenwood_williamson::mean_compression));
  io::Panel forces{.title = "Nominal pressure",
                   .x = separation,
                   .y = {.label = "F/A_{0} [MPa]", .scale = io::Scale::logarithmic},
                   .curves = {}};
  forces.curves.push_back(curve("elastic", apart, [&](double h) { return pressure_in_MPa(elastic(h).force); }));
  forces.curves.push_back(curve("H = 6 GPa", apart, [&](double h) { return pressure_in_MPa(hard(h).force); }));
  forces.curves.push_back(curve("H = 1.5 GPa", apart, [&](double h) { return pressure_in_MPa(soft(h).force); }));
  io::Panel regimes{
      .title = "Who carries the load, H = 6 GPa", .x = separation, .y = {.label = "share of the force"}, .curves = {}};
  for (const auto deformation :
       {jeng_wang::Deformation::elastic, jeng_wang::Deformation::elastic_plastic, jeng_wang::Deformation::plastic}) {
    regimes.curves.push_back(curve(fmt::format("{} asperities", jeng_wang::name(deformation)), apart, [&](double h) {
      const jeng_wang::Patch patch = hard(h);
      return patch.force_by_regime[static_cast<std::size_t>(deformation)] / patch.force;
    }));
  }
  io::Panel areas{.title = "True area and pressure",
                  .x = {.label = "F/A_{0} [MPa]", .scale = io::Scale::logarithmic},
                  .y = {.label = "A_{true}/A_{0}", .scale = io::Scale::logarithmic},
                  .curves = {}};
  const auto add = [&](const char* name, const auto& patch_at, const auto& area_of) {
    io::Curve curve{.name = name, .x = {}, .y = {}};
    for (const double h : evenly(4.0, 0.0, 81)) {
      curve.x.push_back(pressure_in_MPa(patch_at(h).force));
      curve.y.push_back(area_of(patch_at(h)) / nominal_area);
    }
    areas.curves.push_back(curve);
  };
  add("elastic", elastic, [](const auto& patch) { return patch.real_area; });
  add("H = 6 GPa", hard, [](const auto& patch) { return patch.area; });
  add("H = 1.5 GPa", soft, [](const auto& patch) { return patch.area; });
  figure.plot = {.title = "Fig. 7   Rough contact", .panels = {integrals, forces, regimes, areas}};
  return figure;
}

}  // namespace osculate::validation::kildashti2023
