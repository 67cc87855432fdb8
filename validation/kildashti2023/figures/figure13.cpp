// Fig. 13: tangential loading while the normal force changes, and of rough surfaces.

#include <fmt/core.h>

#include <array>

#include "osculate/mechanics/hisakado.hpp"
#include "osculate/mechanics/mindlin.hpp"
#include "validation/kildashti2023/figures.hpp"
#include "validation/kildashti2023/figures/curves.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

/// μF_n0 = 1; at F_n0 everything slides at a displacement of 1.
mindlin::Oblique oblique_of(double coupling) {
  return mindlin::oblique(mindlin::contact(2.0 / 3.0, 1.0, 1.0), coupling);
}

io::Curve path(std::string name) {
  return {.name = std::move(name), .x = {}, .y = {}};
}

template <class Displacement>
void follow(io::Curve& curve, double from, double to, const Displacement& displacement) {
  for (const double force : evenly(from, to, 81)) {
    curve.x.push_back(displacement(force));
    curve.y.push_back(force);
  }
}

io::Curve loop(double coupling, double peak, std::string name) {
  const mindlin::Oblique oblique = oblique_of(coupling);
  io::Curve curve = path(std::move(name));
  follow(curve, 0.0, peak, [&](double force) { return mindlin::oblique_displacement(oblique, force); });
  follow(curve, peak, -peak,
         [&](double force) { return mindlin::oblique_unloading_displacement(oblique, force, peak); });
  follow(curve, -peak, peak,
         [&](double force) { return mindlin::oblique_reloading_displacement(oblique, force, peak); });
  return curve;
}

}  // namespace

Figure figure13() {
  const io::Axis displacement{.label = "displacement δ_{t}/(sliding displacement at F_{n0})"};
  const io::Axis force{.label = "Λ = F_{t}/(μF_{n0})"};
  io::Panel loading{.title = "Oblique loading", .x = displacement, .y = force, .curves = {}};
  for (const double coupling : {0.0, 0.3, 0.6, 1.2}) {
    // Sliding begins at Λ = 1/(1 − Θ).
    const double end = std::min(2.0, coupling < 1.0 ? 1.0 / (1.0 - coupling) : 2.0);
    loading.curves.push_back(path(fmt::format("Θ = {:g}", coupling)));
    const mindlin::Oblique oblique = oblique_of(coupling);
    follow(loading.curves.back(), 0.0, end, [&](double at) { return mindlin::oblique_displacement(oblique, at); });
  }
  constexpr double peak = 0.6;
  io::Panel loops{.title = "Loading, unloading and loading again to ±0.6 μF_{n0}",
                  .x = displacement,
                  .y = force,
                  .curves = {loop(0.0, peak, "Θ = 0"), loop(0.3, peak, "Θ = 0.3"), loop(0.6, peak, "Θ = 0.6")}};
  io::Panel energies{.title = "Energy lost in a loop",
                     .x = {.label = "peak Λ*", .scale = io::Scale::logarithmic},
                     .y = {.label = "ΔE/(μF_{n0} sliding displacement)", .scale = io::Scale::logarithmic},
                     .curves = {}};
  for (const double coupling : {0.0, 0.3, 0.6}) {
    energies.curves.push_back(
        curve(fmt::format("Θ = {:g}", coupling), by_factors(0.05, 0.999 / (1.0 + coupling), 201),
              [&](double amplitude) { return mindlin::oblique_cycle_energy(oblique_of(coupling), amplitude); }));
  }
  const ElasticMaterial steel{.youngs_modulus = 210e9, .poissons_ratio = 0.3};
  const hisakado::Surface rough = hisakado::surface(20e-6, 1e-6, 1000.0, steel, steel, 0.3);
  const double unit = rough.friction * rough.compliance_ratio * rough.height_deviation;
  io::Panel surfaces{.title = "Rough surfaces",
                     .x = {.label = "displacement δ_{t}/(μκσ)"},
                     .y = {.label = "force F_{t}/(μF_{n})"},
                     .curves = {}};
  for (const double h : {-1.0, 0.0, 1.0, 2.0, 3.0}) {
    surfaces.curves.push_back(curve(fmt::format("h = {:g}", h), evenly(0.0, 3.0, 91), [&](double at) {
      return hisakado::tangential_force(rough, h, unit * at) / (rough.friction * hisakado::normal_force(rough, h));
    }));
  }
  Figure figure;
  figure.caption =
      "Oblique loading (70)–(75), F_n = F_n0 (1 + ΘΛ) with Θ = μ dF_n/dF_t and Λ = F_t/(μF_n0): loading up to sliding "
      "at "
      "Λ = 1/(1 − Θ) (none for Θ ≥ 1), loops, and the energy lost in each later loop. Lower right: rough surfaces "
      "after "
      "Hisakado and Tsukizoe (78)–(84) at a constant separation h, any sign. Inferred: the quantities drawn; the "
      "values of "
      "Θ and h were chosen here.";
  figure.plot = {.title = "Fig. 13   Tangential force under oblique loading and of rough surfaces",
                 .panels = {loading, loops, energies, surfaces}};
  return figure;
}

}  // namespace osculate::validation::kildashti2023
