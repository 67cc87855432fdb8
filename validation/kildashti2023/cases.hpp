#pragma once
// The three poses of the review's Fig. 3. Its orientation angles are not defined in the text, so that reproduction
// starts from the relative radii that the printed forces decode to, as far as those are known. Of cases 1 and 2 R_i is
// the cap and one R_j reproduces the printed forces of both Table 1 and Table 2: its last digit comes from there.

#include <algorithm>
#include <array>
#include <string_view>

#include "validation/comparison.hpp"

namespace osculate::validation::kildashti2023 {

/// The review's curvature floor, in units of the volume-equivalent radius.
inline constexpr double radius_cap = 10.0;

/// Relative radii of a pose.
struct Radii {
  double R_i;
  double R_j;
};

struct Case {
  std::string_view name;
  Printed R_i;  ///< in units of R_vol
  Printed R_j;
  bool R_i_at_cap;  ///< R_i is radius_cap itself: exact, and both bodies are flat along it

  Interval R_i_range() const { return R_i_at_cap ? Interval{R_i.value, R_i.value} : rounded(R_i.value, R_i.decimals); }
  Interval R_j_range() const { return rounded(R_j.value, R_j.decimals); }

  Radii radii() const { return {R_i.value, R_j.value}; }

  /// What the rounding of the radii makes of a quantity that grows with both, or falls with both.
  template <class Quantity>
  Interval range_of(const Quantity& quantity) const {
    const double at_low = quantity(Radii{R_i_range().low, R_j_range().low});
    const double at_high = quantity(Radii{R_i_range().high, R_j_range().high});
    return {std::min(at_low, at_high), std::max(at_low, at_high)};
  }
};

inline constexpr std::array<Case, 3> cases{{
    {"1", {radius_cap, 0}, {0.22716, 5}, true},
    {"2", {radius_cap, 0}, {0.22849, 5}, true},
    {"3", {0.3757, 4}, {0.2132, 4}, false},
}};

}  // namespace osculate::validation::kildashti2023
