#pragma once
// Where particles start: on a lattice, or at random without touching each other or the walls.

#include <cstdint>
#include <variant>
#include <vector>

#include "osculate/dynamics/random.hpp"
#include "osculate/dynamics/setup.hpp"

namespace osculate {

/// Room for particles: their whole bounding spheres or, in `insert_randomly`, their centroids lie inside.
struct BoxRegion {
  Vec3 lower, upper;  ///< [m]
};
/// An upright cylinder.
struct CylinderRegion {
  Vec3 base;      ///< centre of the lower end [m]
  double radius;  ///< > 0 [m]
  double height;  ///< > 0 [m]
};
struct SphereRegion {
  Vec3 centre;    ///< [m]
  double radius;  ///< > 0 [m]
};
using Region = std::variant<BoxRegion, CylinderRegion, SphereRegion>;

/// Throws InputError unless the region has a volume.
void validate(const Region& region);
double volume(const Region& region);
bool contains(const Region& region, const Vec3& point);

/// The points of a cubic lattice whose spheres of diameter `spacing` lie inside a region, layer by layer from below.
std::vector<Vec3> lattice(const Region& region, double spacing);

/// One kind of particle to insert.
struct Kind {
  std::int32_t shape;     ///< index into Setup::shapes
  std::int32_t material;  ///< index into Setup::materials
  double weight = 1.0;    ///< ≥ 0: its share by number
};

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
