#pragma once
// The discharges and heaps that `osculate validate flow` shows, and what they should be like.

#include <functional>
#include <string>
#include <vector>

#include "validation/flow/heap.hpp"
#include "validation/flow/hopper.hpp"

namespace osculate::validation {

/// One kind of grain at several widths of the slot.
struct DischargeSeries {
  std::string name;
  std::vector<double> widths;  ///< [m], increasing
  std::vector<Discharge> discharges;
  BeverlooFit fit;
  double light_rate;  ///< at the widest slot and a quarter of the gravity [kg/s]

  /// √g: half of it at a quarter of the gravity.
  double gravity_ratio() const { return light_rate / discharges.back().rate; }
  /// Rates rise with the width, their exponent is 3/2 within 0.3, the line's correlation at least 0.99, k between 0 and
  /// 3.5, and the ratio above a half within a tenth.
  bool agrees() const;
};

/// Angles of heaps that differ in one thing.
struct HeapSeries {
  std::string name;
  std::vector<double> values;  ///< of what differs, increasing
  std::vector<double> angles;  ///< [rad]

  bool rises() const;
};

struct FlowStudy {
  std::vector<DischargeSeries> discharges;
  std::vector<HeapSeries> heaps;
};

struct FlowSettings {
  std::uint64_t particles = 800;  ///< in the hopper
  int heaps = 1;                  ///< of each kind, with seeds 1, 2, …: their mean counts
};

FlowStudy flow_study(const FlowSettings& settings, const std::function<void(double)>& done = {});

}  // namespace osculate::validation
