#pragma once
// A step's work on a chunk of pairs: from poses and velocities to the forces between the bodies.

#include <vector>

#include "dynamics/contact_batches.hpp"
#include "dynamics/kinematics.hpp"
#include "dynamics/pair_chunk.hpp"
#include "dynamics/world.hpp"
#include "osculate/geometry/shape_contacts.hpp"

namespace osculate {

/// What one thread needs to work on a chunk. Holds nothing from one call to the next.
struct ChunkScratch {
  std::vector<std::int32_t> awake;  ///< far pairs for the narrow phase: one a row
  std::vector<std::int32_t> opened;
  std::vector<double> travel;  ///< of the chunk's bodies [m]
  std::vector<LocalPair> pairs;
  ContactCaches caches;
  /// Of pairs given to the narrow phase: far ones, and contacts. Two, because room that shrinks is cleared.
  struct Solved {
    SuperquadricPairs superquadrics;
    ShapePairs shapes;
    ImageShifts images;
    ContactColumns geometry;
  };
  Solved far, contacts;
  /// Of contacts, one a row.
  struct ConstantColumns {
    std::vector<double> reduced_mass, effective_radius, radius_cap;
  };
  ConstantColumns constants;
  Columns<of_arms::columns> arms;
  Columns<of_motion::columns> motion;
  Columns<of_answer::columns> answer;
  std::vector<LawStatus> status;
  ReadAhead ahead;
  double narrow_seconds = 0.0, law_seconds = 0.0;  // these add up
};

/// Whether the forces of single contacts are kept, or only what they add up to on the bodies.
enum class ContactForces { skip, keep };

/// Contacts, forces and memories of a chunk. Trouble is said in chunk.fault.
/// @param next  the chunk that follows, or null: it is fetched meanwhile. No other thread may be at work on it.
void evaluate(PairChunk& chunk, const PairChunk* next, const World& world, const Bodies& bodies,
              const Kinematics& kinematics, ContactForces forces, ChunkScratch& scratch);

/// The geometry of a chunk's contacts, from their caches. Points are near body 1.
ContactColumns geometry_of(const PairChunk& chunk, const World& world, const Bodies& bodies,
                           const Kinematics& kinematics);

/// Half-axes and exponents; zeros for other shapes.
std::array<double, 5> superquadric_numbers(const Shape& shape);

}  // namespace osculate
