#pragma once
// Pairs of bodies near each other, of one kind and with one law: few enough that a step's work on them stays in cache.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/neighbours.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"
#include "osculate/mechanics/contact_law.hpp"

namespace osculate {

/// Which narrow phase a pair goes through.
enum class NarrowPhase : std::int32_t { superquadrics, any_shapes, faces, planes };
constexpr std::uint64_t narrow_phases = 4;

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
enum class Fault : std::uint8_t { none, degenerate, not_converged, too_deep, step_too_long, law_refused };

/// Two bodies by their places among those of a chunk, which has at most two a pair.
struct LocalPair {
  std::uint16_t first, second;
};

/// The largest float that is not above x.
float rounded_down(double x);

/// A pair that does not touch.
struct FarPair {
  LocalPair bodies;
  float quiet_until;  ///< it cannot touch before both travels add up to this [m]
};

/// What a pair that sleeps keeps of its cache: two planes that separate the bodies, in floats. Points and curvatures do
/// not keep while the bodies are apart.
struct FarCache {
  std::array<float, 8> numbers{};  ///< normal 1, normal 2, heights of the planes along them [m]; zeros: knows nothing

  FarCache() = default;
  explicit FarCache(const ContactCache& cache);
  /// The planes are moved out by more than rounding took: they still separate the bodies.
  /// @param radii  of the bodies about their frames [m]; 0 where no such plane is looked at
  ContactCache cache(double radius_1, double radius_2) const;
};

/// A contact's normal spring at the last step: its energy is coefficient · overlap^(p + 1).
struct NormalSpring {
  double overlap;      ///< [m]; 0 before the first step
  double coefficient;  ///< [J/m^(p + 1)]
};

/// A contact's constants.
struct PairConstants {
  double reduced_mass;      ///< [kg]
  double effective_radius;  ///< of the volume-equivalent spheres [m]
  double radius_cap;        ///< [m]
  friend bool operator==(const PairConstants&, const PairConstants&) = default;
};

/// Pairs that touch, one after another. Everything about contact i stands at i.
struct Contacts {
  std::vector<LocalPair> bodies;
  ContactCaches caches;
  std::vector<MemoryLine> memory;        ///< memory_size lines for every eight contacts
  std::vector<std::uint16_t> kind;       ///< which of `constants`
  std::vector<PairConstants> constants;  ///< different ones; among equal bodies there is one
  std::vector<NormalSpring> spring;
  std::vector<Vec3> force;   ///< on body 1 [N]
  std::vector<Vec3> couple;  ///< on body 1 [N m]; empty where the law makes none

  std::size_t size() const { return bodies.size(); }
};

/// Force and torque on a body by the contacts of one chunk: a line of the cache.
struct alignas(64) Wrench {
  /// x, y, z of the force [N] and a zero, x, y, z of the torque about the centroid [N m] and a zero.
  std::array<double, 8> numbers{};

  Vec3 force() const { return {numbers[0], numbers[1], numbers[2]}; }
  Vec3 torque() const { return {numbers[4], numbers[5], numbers[6]}; }
};

struct PairChunk {
  static constexpr std::size_t most_pairs = 512;

  PairGroup group;
  std::vector<FarPair> far;
  std::vector<FarCache> far_caches;  ///< one for each: looked at when it wakes
  Contacts contacts;

  /// The chunk's bodies; pairs know them by their place here.
  std::vector<std::int32_t> bodies;
  std::vector<Wrench> wrenches;  ///< on each of them

  // Since the start [J].
  double viscous_loss = 0.0, friction_loss = 0.0, hysteresis_loss = 0.0, curvature_gain = 0.0;
  // At the last step.
  double stored_normal = 0.0, stored_tangential = 0.0;  ///< [J]
  double stiffest = 0.0;                                ///< largest dF/dδ over reduced mass [1/s²]
  double image_power = 0.0;                             ///< of forces through the faces of a sheared box [W]
  std::int32_t checked = 0;                             ///< pairs given to the narrow phase
  Fault fault = Fault::none;
  BodyPair fault_pair{};
  double fault_overlap = 0.0;
};

/// Adds a contact with an empty memory: one not yet made.
void append_contact(Contacts& contacts, const LocalPair& bodies, const ContactCache& cache,
                    const PairConstants& constants, const ContactLaw& law);

/// Appends contact `i` of another list with everything it remembers.
void append_contact(Contacts& contacts, const Contacts& from, std::size_t i, const ContactLaw& law);

/// What a contact remembers becomes another one's; its own is as if it were new.
void move_memory(Contacts& contacts, std::size_t from, std::size_t to, const ContactLaw& law);

/// Room for the pairs that a chunk has and for a sixteenth more.
void fit_room(PairChunk& chunk);

/// The same where there is no room for one more: growing by its half or double would leave it half empty.
inline void make_room_for_one(PairChunk& chunk) {
  const bool is_full =
      chunk.far.size() == chunk.far.capacity() || chunk.contacts.bodies.size() == chunk.contacts.bodies.capacity();
  if (is_full) fit_room(chunk);
}

/// Removes a contact; the last one takes its place.
void remove_contact(Contacts& contacts, std::size_t i, const ContactLaw& law);

}  // namespace osculate
