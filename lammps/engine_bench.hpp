#pragma once
// What a particle and step cost on the library's own engine and on LAMMPS, from the same settled bodies.

#include <functional>
#include <string>
#include <vector>

#include "io/scene.hpp"

namespace osculate::lammps {

struct EngineBenchOrders {
  std::vector<int> ranks;
  int rounds;           ///< every engine has its turn in each
  std::uint64_t steps;  ///< of a turn
};

/// One engine's turns: the least of them all, of a particle and step [ns].
struct EngineTimes {
  std::string engine;
  double wall, processor;  ///< the second of the busiest rank, waiting for others included
  double steps_a_list;     ///< steps between two lists of neighbours
};

struct EngineBench {
  std::size_t particles;
  double contacts;                   ///< of a particle, walls counted
  std::vector<EngineTimes> engines;  ///< the library's own on one thread, then LAMMPS on each number of ranks
};

/// Runs the scene to its end on the library's engine, then measures from there. All ranks come here; the first one gets
/// the times. `progress` is told the share that is done.
EngineBench time_engines(const io::Scene& scene, const EngineBenchOrders& orders,
                         const std::function<void(double)>& progress);

}  // namespace osculate::lammps
