// Fig. 6: the equilibrium curve of elliptical JKR contacts.

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "osculate/mechanics/johnson_greenwood.hpp"
#include "validation/kildashti2023/figures.hpp"
#include "validation/kildashti2023/figures/curves.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

constexpr std::array<double, 4> ratios{1.0, 2.0, 5.0, 44.0};

/// R = (R_i R_j)^{1/2} = 1.
johnson_greenwood::Pair pair_of(double ratio) {
  return {.R_i = std::sqrt(ratio), .R_j = 1.0 / std::sqrt(ratio), .modulus = 1.0, .work_of_adhesion = 1e-6};
}

/// States along the curve in the theory's own units; the part that no control can hold is apart.
struct EquilibriumCurve {
  std::vector<johnson_greenwood::State> held;      ///< from snap-off on
  std::vector<johnson_greenwood::State> unstable;  ///< up to snap-off
};

EquilibriumCurve states_of(const johnson_greenwood::Pair& pair) {
  const double snap_off = johnson_greenwood::snap_off(pair).a_c;
  const johnson_greenwood::Units units = johnson_greenwood::units(pair);
  EquilibriumCurve curve;
  for (const double a_c : by_factors(0.25 * snap_off, snap_off, 40))
    curve.unstable.push_back(johnson_greenwood::at_major_axis(pair, a_c));
  for (double a_c = snap_off; curve.held.empty() || curve.held.back().force < 3.0 * units.force; a_c *= 1.02)
    curve.held.push_back(johnson_greenwood::at_major_axis(pair, a_c));
  return curve;
}

using Of = double (*)(const johnson_greenwood::State&, const johnson_greenwood::Units&);

double force(const johnson_greenwood::State& state, const johnson_greenwood::Units& units) {
  return state.force / units.force;
}
double overlap(const johnson_greenwood::State& state, const johnson_greenwood::Units& units) {
  return state.overlap / units.overlap;
}
double axis_ratio(const johnson_greenwood::State& state, const johnson_greenwood::Units&) {
  return state.axis_ratio;
}
double size(const johnson_greenwood::State& state, const johnson_greenwood::Units& units) {
  return std::sqrt(state.a_c * state.b_c) / units.length;
}

io::Panel panel(std::string title, io::Axis x, Of of_x, io::Axis y, Of of_y) {
  io::Panel panel{.title = std::move(title), .x = std::move(x), .y = std::move(y), .curves = {}};
  constexpr std::array<io::Colour, 4> colours{io::palette::blue, io::palette::orange, io::palette::green,
                                              io::palette::red};
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const johnson_greenwood::Pair pair = pair_of(ratios[i]);
    const johnson_greenwood::Units units = johnson_greenwood::units(pair);
    const EquilibriumCurve states = states_of(pair);
    const auto add = [&](const std::vector<johnson_greenwood::State>& of, std::string name, io::Mark mark) {
      io::Curve curve{.name = std::move(name), .x = {}, .y = {}, .mark = mark, .colour = colours[i]};
      for (const auto& state : of) {
        curve.x.push_back(of_x(state, units));
        curve.y.push_back(of_y(state, units));
      }
      panel.curves.push_back(curve);
    };
    add(states.held, fmt::format("R_{{i}}/R_{{j}} = {:g}", ratios[i]), io::Mark::line);
    add(states.unstable, "", io::Mark::dotted);
  }
  return panel;
}

}  // namespace

Figure figure6() {
  const io::Axis force_axis{.label = "force F/(3π R W)"};
  Figure figure;
  figure.caption =
      "Equilibrium of elliptical JKR contacts (19)–(28), R = √(R_i R_j), in units of force 3πRW, length "
      "l = (9πWR²/(4Ê))^{1/3} and overlap l²/R. Dotted: states that no contact can hold, beyond snap-off, where the "
      "overlap is least. Lower right: the pull-off force, −½ for a circle. Inferred: the quantities and the ratios; 44 "
      "is that of cases 1 and 2.";
  figure.plot = {
      .title = "Fig. 6   Elliptical contact with adhesion",
      .panels = {
          panel("Force and overlap", {.label = "overlap δ R/l^{2}"}, overlap, force_axis, force),
          panel("Size of the contact", force_axis, force, {.label = "size (a_{c} b_{c})^{½}/l"}, size),
          panel("Shape of the contact", force_axis, force, {.label = "axis ratio g = b_{c}/a_{c}"}, axis_ratio)}};
  figure.plot.panels[0].y.range = io::PlotRange{-0.6, 1.0};
  figure.plot.panels[0].x.range = io::PlotRange{-1.2, 1.6};
  figure.plot.panels[1].x.range = figure.plot.panels[2].x.range = io::PlotRange{-0.6, 1.0};
  figure.plot.panels[1].y.range = io::PlotRange{0.0, 1.6};
  figure.plot.panels.push_back({.title = "Pull-off force",
                                .x = {.label = "radius ratio R_{i}/R_{j}", .scale = io::Scale::logarithmic},
                                .y = {.label = "pull-off force/(3π R W)"},
                                .curves = {curve("", by_factors(1.0, 100.0, 61), [](double ratio) {
                                  const johnson_greenwood::Pair pair = pair_of(ratio);
                                  return johnson_greenwood::pull_off(pair).force / johnson_greenwood::units(pair).force;
                                })}});
  return figure;
}

}  // namespace osculate::validation::kildashti2023
