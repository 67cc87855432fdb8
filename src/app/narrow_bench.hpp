#pragma once
// What a contact costs: time of the narrow phase for classes of superquadric pairs, against libccd in the same run.

#include <cstddef>
#include <string>
#include <vector>

#include "app/stopwatch.hpp"
#include "osculate/shapes/superquadric.hpp"

namespace osculate::app {

/// Pairs whose bodies are drawn from a list of shapes; every body is scaled to R_vol = 1 m.
struct PairClass {
  std::string name;
  std::vector<Superquadric> shapes;
};

/// The classes of the reference table, and one of general real exponents.
std::vector<PairClass> narrow_classes();

struct NarrowSettings {
  std::size_t pairs = 1024;
  int repetitions = 31;
  double overlap = 0.01;        ///< / R_vol
  double pose_change = 1e-4;    ///< [rad] and / R_vol between two warm calls
  double epa_tolerance = 1e-6;  ///< of libccd's EPA [m²]
  unsigned seed = 1;
};

/// Times are per contact, curvatures and directions included.
struct NarrowTimes {
  std::string name;
  Timing warm_batched, warm_scalar;
  Timing cold_batched, cold_scalar;
  Timing separated_batched, separated_scalar;  ///< gap of 1 % R_vol, separating direction cached
  Timing ccd;                                  ///< GJK/EPA, no curvature
  std::size_t unresolved = 0;                  ///< pairs not converged in the cold runs
  std::size_t ccd_failures = 0;                ///< pairs that libccd found apart or gave up on
  double ccd_depth_error = 0.0;                ///< median |Δδ| / δ of libccd
};

NarrowTimes time_narrow_phase(const PairClass& pair_class, const NarrowSettings& settings);

/// The elliptical Hertz contact, from the radii of relative curvature to force, ellipse, pressure, stiffness and
/// energy.
Timing time_hertz(const NarrowSettings& settings);

}  // namespace osculate::app
