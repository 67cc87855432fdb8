#pragma once
// Every law there is, by name: what it is, which numbers it wants, with which others it goes; and from a choice of them
// a ContactLaw. Scene files, the program's help and the documentation read the same table.

#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "osculate/mechanics/contact_law.hpp"
#include "osculate/mechanics/material.hpp"

namespace osculate {

/// What a law is about. A choice holds at most one law of each slot, and always a normal one.
enum class LawSlot : std::uint8_t {
  normal,       ///< what pushes the bodies apart
  adhesion,     ///< replaces the normal force by one that also pulls
  roughness,    ///< replaces the normal force by that of asperities on the bulk
  plasticity,   ///< replaces the normal force by one that yields
  dissipation,  ///< a dashpot along the normal
  tangential,   ///< friction
  twisting,     ///< a couple about the normal
  rolling,      ///< force and couple of creepage, in place of a tangential law
};
inline constexpr std::size_t law_slots = 8;
std::string_view name(LawSlot slot);

/// A number that a law wants.
struct LawParameter {
  enum class Bound : std::uint8_t { included, excluded };

  std::string_view name;     ///< "dissipative_time"
  std::string_view symbol;   ///< "A"
  std::string_view unit;     ///< "s"; "" for a pure number
  std::string_view meaning;  ///< "viscous time of the material"
  double least = 0.0;
  Bound least_bound = Bound::included;
  double most = std::numeric_limits<double>::infinity();
  Bound most_bound = Bound::excluded;
  std::optional<double> standard = {};  ///< taken where none is given; without it the parameter is required

  bool allows(double value) const;
  std::string range() const;  ///< "> 0", "in (0, 1]"
};

/// A law that this one does not go with, or all laws of a slot but some.
struct LawConflict {
  std::string_view other;                      ///< the law's name, or the slot's
  std::string_view reason;                     ///< "a dashpot that ... needs a Hertz contact"
  std::span<const std::string_view> but = {};  ///< laws of the slot with which it goes all the same
};

/// One law of the registry.
struct LawDescription {
  std::string_view name;
  LawSlot slot;
  std::string_view title;
  std::string_view formula;    ///< one line
  std::string_view equations;  ///< of the review, "(37),(38)"; "" where it has none
  std::string_view source;     ///< keys of docs/references.md
  std::span<const LawParameter> parameters;
  std::size_t memory;  ///< doubles a contact
  std::span<const LawConflict> conflicts;
};

/// All laws, slot by slot.
std::span<const LawDescription* const> law_registry();

/// Throws InputError, with the nearest name, when there is none.
const LawDescription& law_named(std::string_view name);

/// A law by name, with values for its parameters; those left out take their standard value.
struct ChosenLaw {
  std::string name;
  std::map<std::string, double> parameters;
};

/// The laws of one pair of materials, in any order.
using LawChoice = std::vector<ChosenLaw>;

/// Throws InputError for an unknown law or parameter, one out of range or missing, two laws of a slot, no normal law,
/// laws that do not go together (with the reason), bad materials. Parameters and materials are checked here, once:
/// evaluation does not throw for them.
/// What is fast: hertz with brilliantov, tsuji or no dashpot, and no friction, mindlin, cundall_strack, di_renzo or
/// tsuji_tangential runs in SIMD batches altogether; of jkr and jamari_schipper the normal force does. The rest runs
/// contact by contact.
ContactLaw make_contact_law(const LawChoice& choice, const ElasticMaterial& material_1,
                            const ElasticMaterial& material_2);

/// The same law composed of its parts, without the batches that do all at once: what they are compared with.
ContactLaw make_contact_law_scalar(const LawChoice& choice, const ElasticMaterial& material_1,
                                   const ElasticMaterial& material_2);

}  // namespace osculate
