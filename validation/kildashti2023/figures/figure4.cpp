// Fig. 4: force against overlap of the accurate and of the simplified model in the three poses.

#include <fmt/core.h>

#include <cmath>

#include "osculate/mechanics/hertz.hpp"
#include "validation/kildashti2023/cases.hpp"
#include "validation/kildashti2023/figures.hpp"
#include "validation/kildashti2023/figures/curves.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

/// Dense near zero, where the semi-axes rise steeply.
const std::vector<double>& overlaps() {
  static const std::vector<double> values = [] {
    std::vector<double> squares = evenly(0.0, 1.0, 101);
    for (double& value : squares) value *= 0.02 * value;
    return squares;
  }();
  return values;
}

/// Lengths in R_vol, forces in Ê R_vol².
double elliptical(double R_i, double R_j, double overlap) {
  return 1e3 * hertz::force(contact_ellipse(R_i, R_j), 1.0, overlap);
}

double circular(double radius, double overlap) {
  return elliptical(radius, radius, overlap);
}

io::Panel panel_of(const Case& pose) {
  io::Panel panel{.title = fmt::format("case {}: R_{{i}} = {:g}, R_{{j}} = {:g} R_{{vol}}", pose.name, pose.R_i.value,
                                       pose.R_j.value),
                  .x = {.label = "overlap δ/R_{vol} [%]"},
                  .y = {.label = "force F/(Ê R_{vol}^{2}) [10^{−3}]"},
                  .curves = {}};
  std::vector<double> percent = overlaps();
  for (double& value : percent) value *= 100.0;
  const auto add = [&](const char* name, io::Mark mark, const auto& force) {
    panel.curves.push_back(curve(name, overlaps(), force, mark));
    panel.curves.back().x = percent;
  };
  add("accurate: elliptical Hertz", io::Mark::line,
      [&](double overlap) { return elliptical(pose.R_i.value, pose.R_j.value, overlap); });
  if (pose.R_i_at_cap) {
    add("simplified: Gaussian curvature, capped", io::Mark::line,
        [&](double overlap) { return circular(0.5 * radius_cap, overlap); });
  } else {
    // 1/R = Σ √(Gaussian curvature) is largest when both bodies are curved alike: Minkowski's inequality.
    add("simplified, not below", io::Mark::line,
        [&](double overlap) { return circular(std::sqrt(pose.R_i.value * pose.R_j.value), overlap); });
  }
  add("spheres of equal volume", io::Mark::dashed, [](double overlap) { return circular(0.5, overlap); });
  return panel;
}

}  // namespace

Figure figure4() {
  Figure figure;
  figure.caption =
      "Normal force against overlap in the three poses: the elliptical Hertz force from the decoded radii, the "
      "simplified "
      "model (17),(18) with γ = 1, and spheres of equal volume. In case 3 the relative radii bound the simplified "
      "force "
      "from below only. Lower right: the semi-axes of the accurate model. Inferred: everything but the radii, which "
      "the "
      "printed tables decode to; the range of overlap.";
  figure.plot = {.title = "Fig. 4   Accurate and simplified normal force", .panels = {}};
  for (const auto& pose : cases) figure.plot.panels.push_back(panel_of(pose));
  io::Panel axes{.title = "Semi-axes of the contact",
                 .x = {.label = "overlap δ/R_{vol} [%]"},
                 .y = {.label = "semi-axes over R_{vol}"},
                 .curves = {}};
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {  // case 2 cannot be told from case 1
    const Case& pose = cases[i];
    const char* label = i == 0 ? "1, nearly 2" : "3";
    const io::Colour colour = i == 0 ? io::palette::blue : io::palette::orange;
    const ContactEllipse ellipse = contact_ellipse(pose.R_i.value, pose.R_j.value);
    io::Curve major{.name = fmt::format("a_{{c}}, case {}", label), .x = {}, .y = {}, .colour = colour};
    io::Curve minor{
        .name = fmt::format("b_{{c}}, case {}", label), .x = {}, .y = {}, .mark = io::Mark::dashed, .colour = colour};
    for (const double overlap : overlaps()) {
      const hertz::Contact contact = hertz::contact(ellipse, 1.0, overlap, pose.R_j.value);
      major.x.push_back(100.0 * overlap);
      major.y.push_back(contact.a_c);
      minor.x.push_back(100.0 * overlap);
      minor.y.push_back(contact.b_c);
    }
    axes.curves.push_back(major);
    axes.curves.push_back(minor);
  }
  figure.plot.panels.push_back(axes);
  return figure;
}

}  // namespace osculate::validation::kildashti2023
