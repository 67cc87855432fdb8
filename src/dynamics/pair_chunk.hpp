#pragma once
// Pairs of bodies near each other, of one kind and with one law: few enough that a step's work on them stays in cache.

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/neighbours.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"
#include "osculate/mechanics/contact_law.hpp"

namespace osculate {

/// Which narrow phase a pair goes through.
enum class NarrowPhase : std::int32_t { superquadrics, any_shapes };

/// What a pair is: chunks hold pairs of one group.
struct PairGroup {
  NarrowPhase narrow_phase;
  std::int32_t law;  ///< index into the setup's interactions
  friend auto operator<=>(const PairGroup&, const PairGroup&) = default;
};

/// Eight doubles: a line of a block of contact memory.
struct alignas(64) MemoryLine {
  double lanes[law_lanes];
};

/// The memory as a contact law wants it.
inline std::span<double> doubles_of(std::vector<MemoryLine>& memory) {
  if (memory.empty()) return {};
  return {memory.data()->lanes, memory.size() * law_lanes};
}

/// What went wrong with a pair in a step.
enum class Fault : std::uint8_t { none, degenerate, not_converged, too_deep, law_refused };

/// A contact that has a memory.
struct Slots {
  static constexpr std::int32_t unused = -1;

  std::vector<std::int32_t> owner;       ///< the pair, or `unused`
  std::vector<MemoryLine> memory;        ///< memory_size lines for every eight slots
  std::vector<double> reduced_mass;      ///< [kg]
  std::vector<double> effective_radius;  ///< of the volume-equivalent spheres [m]
  std::vector<Vec3> force;               ///< on body 1 [N]
  std::vector<Vec3> point;               ///< [m]
  std::vector<Vec3> couple;              ///< on body 1 [N m]; empty where the law makes none

  std::size_t size() const { return owner.size(); }
};

struct PairChunk {
  static constexpr std::size_t most_pairs = 512;
  static constexpr double awake = -1.0;

  PairGroup group;
  std::vector<BodyPair> pairs;      ///< sorted
  std::vector<double> quiet_until;  ///< the pair cannot touch before both travels add up to this [m], or `awake`
  std::vector<std::int32_t> slot;   ///< or Slots::unused
  ContactCaches caches;
  Slots slots;

  // Since the start [J].
  double viscous_loss = 0.0, friction_loss = 0.0, hysteresis_loss = 0.0;
  // At the last step.
  double stored_normal = 0.0, stored_tangential = 0.0;  ///< [J]
  double stiffest = 0.0;                                ///< largest dF/dδ over reduced mass [1/s²]
  std::int32_t checked = 0, contacts = 0;
  Fault fault = Fault::none;
  BodyPair fault_pair{};
  double fault_overlap = 0.0;
};

/// The memory of one contact, lane by lane.
std::span<double> read_memory(const Slots& slots, std::size_t slot, std::span<double> values);
void write_memory(Slots& slots, std::size_t slot, std::span<const double> values);

/// A slot for a pair, the first unused one. The memory is zero: a contact not yet made.
std::size_t take_slot(PairChunk& chunk, std::size_t pair, const ContactLaw& law);

}  // namespace osculate
