#include "app/pair_comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "io/table.hpp"
#include "osculate/shapes/superquadric.hpp"

namespace osculate::app {
namespace {

constexpr std::size_t lines_listed = 12;

/// The columns of io::reference_columns of one line.
struct Known {
  Vec3 normal;
  double depth;
  Vec3 on_1, on_2;
  double k1_max, k1_min, k2_max, k2_min;
  double gap_to_next_minimum;
};

Known known_answer(const io::PairBlock& block, std::size_t i) {
  const auto at = [&](std::size_t column) { return block.reference[column][i]; };
  return {.normal = {at(0), at(1), at(2)},
          .depth = at(3),
          .on_1 = {at(4), at(5), at(6)},
          .on_2 = {at(7), at(8), at(9)},
          .k1_max = at(10),
          .k1_min = at(11),
          .k2_max = at(12),
          .k2_min = at(13),
          .gap_to_next_minimum = at(14)};
}

/// The larger of two differences; a NaN is the worst of all and never lost.
double worse(double a, double b) {
  return b <= a || std::isnan(a) ? a : b;
}

double radius_of(const Superquadric& shape) {
  return volume_equivalent_radius(mass_properties(shape).volume);
}

/// By the chord, which keeps its digits for small angles.
double angle_between(const Vec3& a, const Vec3& b) {
  return 2.0 * std::asin(std::min(1.0, 0.5 * (a - b).norm()));
}

double curvature_difference(const PrincipalCurvatures& found, double max, double min, double radius) {
  const auto difference = [&](double computed, double reference) {
    return std::fabs(computed - reference) / std::max(std::fabs(reference), 1.0 / radius);
  };
  return worse(difference(found.max, max), difference(found.min, min));
}

}  // namespace

ClassDifferences& PairComparison::of_class(const std::string& name) {
  const auto found = std::find_if(classes_.begin(), classes_.end(), [&](const auto& c) { return c.name == name; });
  if (found != classes_.end()) return *found;
  classes_.push_back({.name = name, .failing = {}});
  return classes_.back();
}

void PairComparison::add(const io::PairBlock& block, const ContactColumns& computed) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    ClassDifferences& worst = of_class(block.classes.empty() ? "all" : block.classes[i]);
    ++worst.lines;
    const ContactGeometry contact = computed.get(i);
    const Known known = known_answer(block, i);
    const Superquadric shape_1 = block.shape_1(i);
    const double radius_1 = radius_of(shape_1);
    const double radius_2 = radius_of(block.shape_2(i));
    const double radius = std::min(radius_1, radius_2);

    const double depth = std::fabs(contact.overlap - known.depth) / radius;
    worst.depth = worse(worst.depth, depth);
    bool good = is_resolved(contact.status) && depth <= tolerances_.depth;
    if (contact.status == ContactStatus::ambiguous) ++worst.ambiguous;
    if (known.gap_to_next_minimum > tolerances_.next_minimum * shape_1.half_axes.x()) {
      const double normal = angle_between(contact.normal, known.normal);
      const double curvature = worse(curvature_difference(contact.curvature_1, known.k1_max, known.k1_min, radius_1),
                                     curvature_difference(contact.curvature_2, known.k2_max, known.k2_min, radius_2));
      worst.normal = worse(worst.normal, normal);
      worst.curvature = worse(worst.curvature, curvature);
      worst.point = worse(worst.point, (contact.on_1 - known.on_1).norm() / radius);
      worst.point = worse(worst.point, (contact.on_2 - known.on_2).norm() / radius);
      good = good && normal <= tolerances_.normal && curvature <= tolerances_.curvature;
    } else {
      good = good && contact.status == ContactStatus::ambiguous;
    }
    if (!good) worst.failing.push_back(block.lines[i]);
  }
}

bool PairComparison::passed() const {
  return std::all_of(classes_.begin(), classes_.end(), [](const auto& c) { return c.failing.empty(); });
}

std::string to_text(const PairComparison& comparison) {
  io::Table table{
      .header = {"class", "lines", "|Δδ|/R_vol", "normal [rad]", "points/R_vol", "curvature", "ambiguous", "failing"},
      .rows = {}};
  std::size_t lines = 0;
  std::vector<std::size_t> failing;
  for (const ClassDifferences& worst : comparison.classes()) {
    table.rows.push_back({worst.name, fmt::format("{}", worst.lines), fmt::format("{:.1e}", worst.depth),
                          fmt::format("{:.1e}", worst.normal), fmt::format("{:.1e}", worst.point),
                          fmt::format("{:.1e}", worst.curvature), fmt::format("{}", worst.ambiguous),
                          fmt::format("{}", worst.failing.size())});
    lines += worst.lines;
    failing.insert(failing.end(), worst.failing.begin(), worst.failing.end());
  }
  const PairTolerances bars;
  std::string text = "Worst difference from the reference columns\n" + io::to_text(table);
  text += fmt::format(
      "Bars: |Δδ|/R_vol ≤ {:.0e}, normal ≤ {:.0e} rad, curvature ≤ {:.0e} relative (or / R_vol where nearly flat);\n"
      "where the next minimum is within {:.0e} of a1 only the depth counts, and the status must say ambiguous.\n",
      bars.depth, bars.normal, bars.curvature, bars.next_minimum);
  if (failing.empty()) return text + fmt::format("All {} lines pass.\n", lines);
  text += fmt::format("{} of {} lines fail: line", failing.size(), lines);
  std::sort(failing.begin(), failing.end());
  for (std::size_t i = 0; i < std::min(lines_listed, failing.size()); ++i)
    text += fmt::format("{} {}", i == 0 ? "" : ",", failing[i]);
  return text + (failing.size() > lines_listed ? ", ...\n" : "\n");
}

}  // namespace osculate::app
