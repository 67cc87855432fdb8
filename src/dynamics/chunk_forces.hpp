#pragma once
// A step's work on a chunk of pairs: from poses and velocities to the forces between the bodies.

#include <vector>

#include "dynamics/pair_chunk.hpp"
#include "dynamics/world.hpp"
#include "osculate/geometry/shape_contacts.hpp"

namespace osculate {

/// The bodies at the end of a step, before its second half kick.
struct Kinematics {
  const Bodies* bodies;                     ///< with the velocities of the middle of the step
  std::vector<Vec3> mean_angular_velocity;  ///< of the step [rad/s], world
  /// Extrapolated to the end of the step with the forces of its beginning.
  std::vector<Vec3> velocity;          ///< [m/s]
  std::vector<Vec3> angular_velocity;  ///< [rad/s], world
  /// A bound of how far any point of the body has moved since the list of pairs was made [m].
  std::vector<double> travel;
  double time_step;  ///< [s]; 0 when forces are evaluated for the first time
};

/// What one thread needs to work on a chunk. Holds nothing from one call to the next.
struct ChunkScratch {
  std::vector<std::int32_t> awake;  ///< pairs for the narrow phase: one a row
  std::vector<std::int32_t> row;    ///< of each slot, or −1
  SuperquadricPairs superquadrics;
  ShapePairs shapes;
  ContactCaches caches;
  ContactColumns contacts;
  Columns<22> law_in;
  Columns<13> law_out;
  std::vector<LawStatus> status;
  double narrow_seconds = 0.0, law_seconds = 0.0;  // these add up
};

/// Contacts, forces and memories of a chunk. Trouble is said in chunk.fault.
void evaluate(PairChunk& chunk, const World& world, const Kinematics& kinematics, ChunkScratch& scratch);

/// The contact geometry of those pairs of a chunk that have a slot, in the order of the slots, from their caches.
/// Points are near body 1.
ContactColumns slot_geometry(const PairChunk& chunk, const World& world, const Bodies& bodies,
                             std::vector<std::int32_t>& slots);

}  // namespace osculate
