#pragma once
// What a time step of a settled scene costs, particle by particle, and whether it misses a contact.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/stopwatch.hpp"
#include "osculate/dynamics/simulation.hpp"

namespace osculate::app {

struct SceneBenchSettings {
  std::vector<int> particles;  ///< a scene, one after another; none: its own number
  int repetitions = 15;
  int steps = 100;                      ///< of a repetition
  std::string tangential = "di_renzo";  ///< the law of friction
  /// Where settled states are kept: those that are there are not made again, the others are left there. Empty: nowhere.
  std::filesystem::path settled;
};

/// Particles of one shape that fell into a box of planes.
struct BenchScene {
  std::string name;
  std::string shape;
  Superquadric particle;
  int particles;
  double youngs_modulus;  ///< [Pa]
  double time_step;       ///< [s]
  double settling_time;   ///< [s]
};

std::vector<BenchScene> bench_scenes();

struct SceneTimes {
  std::string name, shape;
  std::size_t particles;
  Timing step;             ///< of a particle, processor time on one core [ns]
  Timing two_threads;      ///< the same in wall time on two threads, per particle [ns]
  Timing one_thread_wall;  ///< and on one
  Timing ccd;              ///< libccd's penetration of the scene's contacts between particles alone, per particle [ns]
  StageTimes shares;       ///< of the time on one core, adding up to 1
  double coordination;     ///< contacts of a particle
  double contacts;         ///< per particle
  double candidates;       ///< pairs in the list per particle
  double sphere_neighbours;  ///< particles whose bounding spheres overlap a particle's
  double bytes;              ///< of memory per particle
  double bytes_of_contact;   ///< more bytes for one more contact
  double steps_between_lists;
  std::size_t
      missed;  ///< overlaps above 1e-6 of the bounding radius that an exhaustive search finds and the scene lacks
};

/// Settles the scenes, then measures them in turns. `progress` is told the share that is done. Throws InputError if a
/// state that was kept is another scene's, or cannot be written.
std::vector<SceneTimes> time_scenes(const std::vector<BenchScene>& scenes, const SceneBenchSettings& settings,
                                    const std::function<void(double)>& progress);

}  // namespace osculate::app
