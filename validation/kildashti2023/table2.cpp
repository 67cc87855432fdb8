// Table 2: the normal force of the elliptical JKR theory in the form of Table 1, F/(4/3 Ê R_vol^{1/2} δ^{3/2}).

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/johnson_greenwood.hpp"
#include "validation/kildashti2023/cases.hpp"
#include "validation/kildashti2023/tables.hpp"

namespace osculate::validation::kildashti2023 {
namespace {

/// Where the force is taken, δ/R_vol. Without adhesion the normalised force does not depend on it.
constexpr double overlap = 0.01;

/// Works of adhesion over Ê R_vol; the first stands for W → 0.
constexpr std::array<double, 3> adhesion{0.0, 1e-5, 1e-4};

double normalised_force(const Radii& radii, double work_of_adhesion) {
  const johnson_greenwood::Pair pair{
      .R_i = radii.R_i, .R_j = radii.R_j, .modulus = 1.0, .work_of_adhesion = work_of_adhesion};
  const auto state = johnson_greenwood::at_overlap(pair, overlap);
  if (!state) throw InputError("table 2", "a contact that is open at the table's overlap", "a closed one");
  return state->force / (4.0 / 3.0 * std::pow(overlap, 1.5));
}

constexpr std::array<Printed, 3> printed{{{1.5872, 4}, {1.5884, 4}, {0.5334, 4}}};

}  // namespace

ReproducedTable table2() {
  ReproducedTable table;
  table.title = "Table 2 of the review [KDY23]: elliptical JKR";
  table.preamble = {
      "Forces are F/(4/3 Ê R_vol^½ δ^{3/2}), computed by (19)–(23) from the radii of Table 1 at δ = 0.01 R_vol."};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& pose = cases[i];
    for (const double work : adhesion) {
      const auto force = [&](const Radii& radii) { return normalised_force(radii, work); };
      const bool is_printed = work == 0.0;
      const std::string quantity = is_printed ? "W → 0" : fmt::format("W = {:g} Ê R_vol", work);
      Comparison row = compare(std::string(pose.name), quantity, is_printed ? std::optional(printed[i]) : std::nullopt,
                               force(pose.radii()), pose.range_of(force));
      if (row.verdict == Verdict::differs && !pose.R_i_at_cap) {
        row.verdict = Verdict::contradiction;
        row.remark = "[a]";
      }
      if (row.verdict == Verdict::not_available) row.remark = "[b]";
      table.rows.push_back(row);
    }
  }
  table.notes = {
      "Without adhesion JKR is Hertz with the axis ratio of the exact (13): the printed column is the limit W → 0.",
      "[a] Contradicts Table 1, where the same pose has 0.5345: `osculate review table1`, note [b].",
      "[b] Computed for comparison; the project has no printed number with adhesion."};
  return table;
}

}  // namespace osculate::validation::kildashti2023
