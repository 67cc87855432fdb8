// Table 3: the rough contact of Greenwood and Williamson at a prescribed separation h, as the review factors it:
// (R_c/R_vol)^{1/2} times γ_rough = γ F_{3/2}(h).

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/greenwood_williamson.hpp"
#include "validation/kildashti2023/cases.hpp"
#include "validation/kildashti2023/tables.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

constexpr std::array<double, 3> separations{1.0, 2.0, 3.0};

double shrinkage(double h) {
  return greenwood_williamson::height_integrals(h).three_halves;
}

struct Rows {
  ReproducedTable& table;
  const Case& pose;

  template <class Quantity>
  Comparison& add(const std::string& name, std::optional<Printed> printed, const Quantity& quantity) const {
    table.rows.push_back(
        compare(std::string(pose.name), name, printed, quantity(pose.radii()), pose.range_of(quantity)));
    Comparison& row = table.rows.back();
    if (row.verdict == Verdict::not_available) row.remark = "[b]";
    return row;
  }
};

}  // namespace

ReproducedTable table3() {
  ReproducedTable table;
  table.title = "Table 3 of the review [KDY23]: rough contact at a prescribed separation h";
  table.preamble = {
      "The force is (R_c/R_vol)^½ · γ F_{3/2}(h), with F_{3/2} of (35) and γ of the exact ellipse; radii of Table 1."};
  const auto gamma_rough = [](const Radii& radii, double h) {
    return contact_ellipse(radii.R_i, radii.R_j).gamma() * shrinkage(h);
  };
  const auto root_radius = [](const Radii& radii) { return std::sqrt(contact_ellipse(radii.R_i, radii.R_j).R_c); };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Rows rows{table, cases[i]};
    const bool has_printed = i == 0;
    const auto of_case_1 = [&](const Printed& number) { return has_printed ? std::optional(number) : std::nullopt; };
    rows.add("R_c/R_vol", of_case_1({0.222, 3}),
             [](const Radii& radii) { return contact_ellipse(radii.R_i, radii.R_j).R_c; });
    for (const double h : separations) {
      const bool first = h == separations.front();
      rows.add(fmt::format("γ F_3/2, h = {:g}", h), first ? of_case_1({0.255, 3}) : std::nullopt,
               [&](const Radii& radii) { return gamma_rough(radii, h); });
      Comparison& force = rows.add(fmt::format("force, h = {:g}", h), first ? of_case_1({0.0183, 4}) : std::nullopt,
                                   [&](const Radii& radii) { return root_radius(radii) * gamma_rough(radii, h); });
      if (force.verdict == Verdict::differs) {
        force.verdict = Verdict::contradiction;
        force.remark = "[a]";
      }
    }
  }
  table.notes = {
      fmt::format("[a] The entry contradicts its own factors, which are reproduced: √0.222 · 0.255 = {:.3f}.",
                  std::sqrt(0.222) * 0.255),
      "[b] Computed for comparison; of this table the project has the printed entry of case 1, h = 1, and its "
      "factors."};
  return table;
}

}  // namespace osculate::validation::kildashti2023
