// Fig. 14: rolling with creepage, and twisting.

#include <fmt/core.h>

#include <array>

#include "osculate/mechanics/kalker.hpp"
#include "osculate/mechanics/twisting.hpp"
#include "osculate/mechanics/vermeulen_johnson.hpp"
#include "validation/kildashti2023/figures.hpp"
#include "validation/kildashti2023/figures/curves.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

constexpr double poissons_ratio = 0.25;

/// μF_n = 1, G = 1, c = 1: creepage in units of μF_n/(G c²).
vermeulen_johnson::Contact contact_of(double a_over_b) {
  const kalker::Coefficients coefficients = kalker::coefficients(kalker::table(poissons_ratio), a_over_b);
  return vermeulen_johnson::contact(coefficients, 1.0, 1.0, 1.0, 1.0, 1.0);
}

io::Panel creep_panel() {
  io::Panel panel{.title = "Creep force along the rolling",
                  .x = {.label = "creepage ξ_{x} G c^{2}/(μF_{n})"},
                  .y = {.label = "force −F_{x}/(μF_{n})", .range = io::PlotRange{0.0, 1.1}},
                  .curves = {}};
  constexpr std::array<io::Colour, 3> colours{io::palette::blue, io::palette::orange, io::palette::green};
  const std::array ratios{0.2, 1.0, 5.0};
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const vermeulen_johnson::Contact contact = contact_of(ratios[i]);
    panel.curves.push_back(curve(fmt::format("a/b = {:g}", ratios[i]), evenly(0.0, 1.0, 101), [&](double creepage) {
      return -vermeulen_johnson::force(contact, {.longitudinal = creepage, .lateral = 0.0, .spin = 0.0}).longitudinal;
    }));
    panel.curves.back().colour = colours[i];
    const double end = 1.1 / contact.coefficients.c11;
    panel.curves.push_back(curve("", evenly(0.0, end, 2), [&](double creepage) {
      return -kalker::linear_force(contact.coefficients, 1.0, 1.0, 1.0,
                                   {.longitudinal = creepage, .lateral = 0.0, .spin = 0.0})
                  .longitudinal;
    }));
    panel.curves.back().colour = colours[i];
    panel.curves.back().mark = io::Mark::dotted;
  }
  panel.curves.push_back({.name = "linear theory (86)",
                          .x = {0.0, 1e-9},
                          .y = {0.0, 0.0},
                          .mark = io::Mark::dotted,
                          .colour = io::palette::grey});
  return panel;
}

io::Panel coefficient_panel() {
  const kalker::Table table = kalker::table(poissons_ratio);
  io::Panel panel{.title = "Creepage coefficients, ν = 0.25",
                  .x = {.label = "a/b, along over across the rolling", .scale = io::Scale::logarithmic},
                  .y = {.label = "C_{ij}", .scale = io::Scale::logarithmic},
                  .curves = {}};
  const auto add = [&](const char* name, double kalker::Coefficients::*coefficient) {
    panel.curves.push_back(curve(name, by_factors(0.1, 10.0, 101),
                                 [&](double ratio) { return kalker::coefficients(table, ratio).*coefficient; }));
  };
  add("C_{11}", &kalker::Coefficients::c11);
  add("C_{22}", &kalker::Coefficients::c22);
  add("C_{23}", &kalker::Coefficients::c23);
  add("C_{33}", &kalker::Coefficients::c33);
  return panel;
}

constexpr ElasticMaterial material{.youngs_modulus = 2.0 * (1.0 + poissons_ratio), .poissons_ratio = poissons_ratio};

/// A twisted contact turned to and fro; angle and moment in units of those where a circular contact spins.
io::Panel twisting_panel() {
  io::Panel panel{.title = "Twisting to and fro",
                  .x = {.label = "twist over that of first spinning, circle"},
                  .y = {.label = "moment over that of spinning, circle"},
                  .curves = {}};
  const twisting::Contact circle = twisting::contact(contact_ellipse(1.0, 1.0), 1.0, material, material, 0.3, 1.0);
  const double unit_angle = circle.limit / circle.stiffness;
  for (const double ratio : {1.0, 2.0, 5.0}) {
    const twisting::Contact contact = twisting::contact(contact_ellipse(ratio, 1.0), 1.0, material, material, 0.3, 1.0);
    twisting::Memory memory{};
    io::Curve path{.name = fmt::format("R_{{i}}/R_{{j}} = {:g}", ratio), .x = {0.0}, .y = {0.0}};
    const auto turn_to = [&](double angle) {
      const double from = path.x.back();
      for (int i = 1; i <= 80; ++i) {
        const double at = from + (angle - from) * i / 80;
        const double moment = twisting::advance(memory, contact, unit_angle * (at - path.x.back()));
        path.x.push_back(at);
        path.y.push_back(moment / circle.limit);
      }
    };
    for (const double angle : {2.5, -2.5, 2.5}) turn_to(angle);
    panel.curves.push_back(path);
  }
  return panel;
}

io::Panel torsion_panel() {
  io::Panel panel{.title = "Torsional stiffness",
                  .x = {.label = "radius ratio R_{i}/R_{j}", .scale = io::Scale::logarithmic},
                  .y = {.label = "stiffness/(8/3 G a_{c}^{3})", .scale = io::Scale::logarithmic},
                  .curves = {}};
  for (const double nu : {0.0, 0.25, 0.45}) {
    const ElasticMaterial solid{.youngs_modulus = 2.0 * (1.0 + nu), .poissons_ratio = nu};  // G = 1
    panel.curves.push_back(curve(fmt::format("ν = {:g}", nu), by_factors(1.0, 100.0, 81), [&](double ratio) {
      return 3.0 / 8.0 / twisting::compliance(contact_ellipse(ratio, 1.0), 1.0, solid, solid);
    }));
  }
  return panel;
}

}  // namespace

Figure figure14() {
  Figure figure;
  figure.caption =
      "Rolling after Kalker (86)–(91) and Vermeulen and Johnson (92),(93), c = √(a_c b_c), a along the rolling: creep "
      "force "
      "against creepage with the linear theory, and the coefficients (ν = 0.25). Below: the twisting moment (77) with "
      "its "
      "limit when the contact is turned to and fro, and the torsional stiffness of equal bodies over that of a circle. "
      "Inferred: the quantities drawn and all parameters.";
  figure.plot = {.title = "Fig. 14   Rolling and twisting",
                 .panels = {creep_panel(), coefficient_panel(), twisting_panel(), torsion_panel()}};
  return figure;
}

}  // namespace osculate::validation::kildashti2023
