#pragma once
// Particles that come in while a simulation runs.

#include <cstdint>
#include <limits>
#include <vector>

#include "osculate/dynamics/region.hpp"

namespace osculate {

/// One kind of particle to insert.
struct Kind {
  std::int32_t shape;     ///< index into Setup::shapes
  std::int32_t material;  ///< index into Setup::materials
  double weight = 1.0;    ///< ≥ 0: its share by number
};

/// One particle after another at a rate, in random places and orientations, none nearer than the gap to anything. Kinds
/// come in random order, fixed by the seed; one that finds no place waits for it, and the others behind it.
struct Pour {
  enum class Measure { particles, mass };

  Region region;  ///< of the centroids
  std::vector<Kind> kinds;
  double rate;  ///< > 0 [1/s] or, measured by mass, [kg/s]
  Measure measure = Measure::particles;
  double begin = 0.0;                                              ///< ≥ 0 [s]
  double end = std::numeric_limits<double>::infinity();            ///< > begin [s]
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();  ///< particles in all
  std::uint64_t seed;
  double gap = 0.0;              ///< [m]
  int tries = 100;               ///< for a particle each time it looks for a place
  Vec3 velocity = Vec3::Zero();  ///< of all [m/s]
  double fluctuation = 0.0;      ///< standard deviation of each component added to it [m/s]
};

/// What has come in of a pour.
struct Poured {
  std::uint64_t particles = 0;
  double mass = 0.0;  ///< [kg]
};

/// What should have come in by time t: particles or kg.
double due(const Pour& pour, double t);
/// What did, in the same measure.
double arrived(const Pour& pour, const Poured& poured);

}  // namespace osculate
