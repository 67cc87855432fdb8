#pragma once
// Where particles start: on a lattice, or at random without touching each other or the walls.

#include <cstdint>
#include <vector>

#include "osculate/dynamics/setup.hpp"

namespace osculate {

/// The points of a cubic lattice whose spheres of diameter `spacing` lie inside a region, layer by layer from below.
std::vector<Vec3> lattice(const Region& region, double spacing);

struct RandomInsertion {
  Region region;  ///< of the centroids
  std::vector<Kind> kinds;
  std::uint64_t count;  ///< of particles
  std::uint64_t seed;
  double gap = 0.0;              ///< at least this distance to everything else [m]
  int tries = 10000;             ///< for one particle
  Vec3 velocity = Vec3::Zero();  ///< of all [m/s]
  double fluctuation = 0.0;      ///< standard deviation of each component added to it [m/s]
};

/// Appends particles in random places and orientations to the setup's bodies, none nearer than the gap to another one,
/// to a body that is there already or to a wall: by the narrow phase, not by spheres. Particles come in random order of
/// kinds; the same seed gives the same particles everywhere.
/// Throws InputError if one finds no place in `tries` tries, saying how many did; the setup is then as before.
void insert_randomly(Setup& setup, const RandomInsertion& insertion);

}  // namespace osculate
