#include "validation/curvature_models/spread.hpp"

#include <algorithm>
#include <cmath>

namespace osculate::validation::curvature_models {
namespace {

double quantile(const std::vector<double>& ranked, double share) {
  const double place = share * static_cast<double>(ranked.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, ranked.size() - 1);
  return ranked[below] + (place - std::floor(place)) * (ranked[above] - ranked[below]);
}

Group group_of(const CaseErrors* begin, const CaseErrors* end) {
  Group group{.exponent = begin->input.exponent, .aspect = begin->input.aspect, .overlap = begin->input.overlap};
  std::array<std::vector<double>, models.size()> force, area;
  std::vector<double> point, normal, overlap, potential_force;
  for (const CaseErrors* errors = begin; errors != end; ++errors) {
    const bool potential = is_resolved(errors->potential.status);
    if (!potential) ++group.potential_failures;
    if (potential) {
      point.push_back(errors->potential.point);
      normal.push_back(errors->potential.normal);
      overlap.push_back(errors->potential.overlap);
    }
    if (!errors->has_reference) {
      ++group.unanswered;
      continue;
    }
    ++group.contacts;
    if (potential) potential_force.push_back(errors->potential.force);
    for (std::size_t i = 0; i < models.size(); ++i) {
      force[i].push_back(errors->force[i]);
      area[i].push_back(errors->area[i]);
      group.capped[i] += errors->capped[i] ? 1.0 : 0.0;
    }
  }
  for (std::size_t i = 0; i < models.size(); ++i) {
    group.force[i] = spread_of(force[i]);
    group.area[i] = spread_of(area[i]);
    if (group.contacts > 0) group.capped[i] /= static_cast<double>(group.contacts);
  }
  group.point = spread_of(point);
  group.normal = spread_of(normal);
  group.overlap_error = spread_of(overlap);
  group.potential_force = spread_of(potential_force);
  return group;
}

}  // namespace

Spread spread_of(std::vector<double> sample) {
  if (sample.empty()) return {};
  std::sort(sample.begin(), sample.end());
  return {quantile(sample, 0.05), quantile(sample, 0.5), quantile(sample, 0.95)};
}

std::vector<Group> groups_of(const std::vector<CaseErrors>& errors) {
  std::vector<Group> groups;
  const auto same = [](const ContactCase& a, const ContactCase& b) {
    return a.exponent == b.exponent && a.aspect == b.aspect && a.overlap == b.overlap;
  };
  for (std::size_t i = 0; i < errors.size();) {
    std::size_t end = i;
    while (end < errors.size() && same(errors[end].input, errors[i].input)) ++end;
    groups.push_back(group_of(errors.data() + i, errors.data() + end));
    i = end;
  }
  return groups;
}

}  // namespace osculate::validation::curvature_models
