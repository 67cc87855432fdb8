// Fig. 2: the contact ellipse over the ratio of the radii, exact and approximate.

#include "osculate/mechanics/contact_ellipse.hpp"
#include "validation/kildashti2023/figures.hpp"
#include "validation/kildashti2023/figures/curves.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

constexpr double largest_ratio = 1000.0;

/// A quantity of the exact and of the approximate ellipse.
template <class Quantity>
io::Panel panel(const std::string& title, const char* label, io::Scale scale, const Quantity& quantity) {
  const auto ratios = by_factors(1.0, largest_ratio, 121);
  return {.title = title,
          .x = {.label = "radius ratio R_{i}/R_{j}", .scale = io::Scale::logarithmic},
          .y = {.label = label, .scale = scale},
          .curves = {curve("exact (13)", ratios, [&](double r) { return quantity(contact_ellipse(r, 1.0)); }),
                     curve(
                         "approximation (14)", ratios,
                         [&](double r) { return quantity(contact_ellipse_approximate(r, 1.0)); }, io::Mark::dashed)}};
}

template <class Quantity>
io::Curve error(const char* name, const Quantity& quantity) {
  return curve(name, by_factors(1.0, largest_ratio, 241), [&](double ratio) {
    return 100.0 * (quantity(contact_ellipse_approximate(ratio, 1.0)) / quantity(contact_ellipse(ratio, 1.0)) - 1.0);
  });
}

}  // namespace

Figure figure2() {
  const auto axis_ratio = [](const ContactEllipse& ellipse) { return ellipse.axis_ratio; };
  const auto gamma = [](const ContactEllipse& ellipse) { return ellipse.gamma(); };
  const auto beta = [](const ContactEllipse& ellipse) { return ellipse.beta(); };
  Figure figure;
  figure.caption =
      "Axis ratio b_c/a_c of the contact ellipse and the factors γ (11) of the force and β (12) of the area over the "
      "ratio "
      "of the radii of relative curvature, from the exact equation (13) and from the approximation (14), and the error "
      "of "
      "the latter. Inferred: that the figure belongs to (11)–(14); the range of the ratio.";
  figure.plot = {.title = "Fig. 2   The contact ellipse",
                 .panels = {panel("Axis ratio", "b_{c}/a_{c}", io::Scale::logarithmic, axis_ratio),
                            panel("Force factor", "γ", io::Scale::linear, gamma),
                            panel("Area factor", "β", io::Scale::logarithmic, beta),
                            {.title = "Error of the approximation (14)",
                             .x = {.label = "radius ratio R_{i}/R_{j}", .scale = io::Scale::logarithmic},
                             .y = {.label = "error [%]"},
                             .curves = {error("γ, the force", gamma), error("β, the area", beta)}}}};
  return figure;
}

}  // namespace osculate::validation::kildashti2023
