#pragma once
// The discharges and heaps that `osculate validate flow` shows, and what they should be like.

#include <cstdint>
#include <string>
#include <vector>

#include "validation/flow/heap.hpp"
#include "validation/flow/hopper.hpp"
#include "validation/independent_cases.hpp"

namespace osculate::validation {

/// A hopper at several widths of its slot.
struct DischargeSeries {
  double diameter;             ///< d of the grains [m]
  std::vector<double> widths;  ///< [m], increasing
  std::vector<Discharge> discharges;
  Discharge light;  ///< at the widest slot and a quarter of the gravity
  BeverlooFit fit;
  double overlap;  ///< mean of grains on grains at rest, the largest of the series [m]

  /// √g: half at a quarter of the gravity.
  Discharge gravity_ratio() const;
  bool exponent_agrees() const;
  bool k_agrees() const;
  bool is_straight() const;  ///< W^{2/3} over the width
  bool gravity_agrees() const;
  bool agrees() const;  ///< in all of these
};

/// Of k the range that is commonly quoted for various grains, mostly over flat bottoms. The exponent follows from it:
/// grains of k = 1 or 2 discharge with the power 3/2 of D − k d, and at the widths here that looks like the power 1.3
/// or 1.9 of D − 1.4 d.
namespace expected {
inline constexpr double least_k = 1.0, most_k = 3.5;
inline constexpr double least_exponent = 1.3, most_exponent = 1.9;
inline constexpr double least_correlation = 0.99;
inline constexpr double gravity_ratio = 0.5, gravity_tolerance = 0.05;
}  // namespace expected

/// Mean of several heaps.
struct HeapAngle {
  double mean;   ///< [rad]
  double error;  ///< its standard error [rad], 0 of a single heap
};
HeapAngle mean_angle(const std::vector<double>& angles);

/// Heaps that differ in one thing.
struct HeapSeries {
  std::string name;
  std::vector<double> values;  ///< of what differs, increasing
  std::vector<HeapAngle> angles;

  bool rises() const;
};

struct FlowStudy {
  DischargeSeries discharge;
  std::vector<HeapSeries> heaps;
};

struct FlowSettings {
  std::uint64_t particles = 1200;  ///< in a hopper
  int hoppers = 3;                 ///< of each kind, with seeds 1, 2, …: their mean counts
  int heaps = 2;                   ///< of each kind, with seeds 1, 2, …: their mean counts
  int threads = processors();      ///< simulations at once
};

/// The slots of the study [m].
const std::vector<double>& slot_widths();

FlowStudy flow_study(const FlowSettings& settings, const Done& done = {});

}  // namespace osculate::validation
