#pragma once
// The same scene on the library's own engine and on LAMMPS, step by step beside each other.
//
// Rounding differs from engine to engine and from one number of ranks to the next, and a granular assembly is chaotic:
// trajectories part. What they part by without any other reason is seen in a third run, of the library's engine with
// all bodies begun one unit in the last place aside.

#include <cstdint>
#include <functional>
#include <vector>

#include "io/scene.hpp"

namespace osculate::lammps {

/// The largest difference between two runs: positions in bounding radii, velocities in the scene's speed, angular
/// velocities in speed over radius, quaternions as they are.
struct Difference {
  double single = 0.0;  ///< of bodies that have met one other only, which has met none but them
  double all = 0.0;
};

struct TrajectoryRow {
  double time;                     ///< [s]
  std::size_t single;              ///< bodies as above
  std::size_t met;                 ///< bodies that have met another one
  std::size_t free;                ///< all of them
  Difference nudged;               ///< the library's engine from its own
  std::vector<Difference> lammps;  ///< from the library's engine, one for each number of ranks
};

struct TrajectoryOrders {
  std::vector<int> ranks;
  std::uint64_t steps;  ///< at most: ends when all runs have parted, or all bodies have met a second one
  std::uint64_t every;  ///< steps between looks: fewer than a contact lasts
};

/// All ranks come here; `look` is called on the first one.
void follow_trajectories(const io::Scene& scene, const TrajectoryOrders& orders,
                         const std::function<void(const TrajectoryRow&)>& look);

}  // namespace osculate::lammps
