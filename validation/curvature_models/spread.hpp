#pragma once
// What many contacts of one kind have in common: the middle of their errors, and how far they spread.

#include <vector>

#include "validation/curvature_models/sweep.hpp"

namespace osculate::validation::curvature_models {

/// Of a sample: 5 %, 50 % and 95 % of its values lie below these.
struct Spread {
  double low = 0.0, median = 0.0, high = 0.0;
};
/// Linear interpolation between the ranked values; zeros for an empty sample.
Spread spread_of(std::vector<double> sample);

/// All contacts of one exponent, aspect and overlap.
struct Group {
  double exponent, aspect, overlap;
  std::size_t contacts = 0;    ///< with a reference
  std::size_t unanswered = 0;  ///< without
  std::array<Spread, models.size()> force{}, area{};
  std::array<double, models.size()> capped{};  ///< share of contacts in which a radius was capped
  std::size_t potential_failures = 0;          ///< the geometric potential has no answer
  Spread point{}, normal{}, overlap_error{}, potential_force{};
};
/// In the order of the sweep.
std::vector<Group> groups_of(const std::vector<CaseErrors>& errors);

}  // namespace osculate::validation::curvature_models
