#pragma once
// The pairs of one rank between two neighbour lists, and what their contacts remember on the way from one list, or
// rank, to the next.
//
// A pair with a ghost is evaluated on both ranks that own one of its bodies, from the same numbers: there is nothing to
// send back, and each owner has the contact's memory. Body 1 of a pair is a driven body, or the one with the smaller
// tag, on every rank.

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/chunk_forces.hpp"
#include "lammps/rank_bodies.hpp"

namespace osculate::lammps {

/// The contacts of one atom, packed one after another: partner, number of doubles that follow, and these.
using StowedContacts = std::vector<double>;

/// Two atoms by their local indices, the first one owned.
struct AtomPair {
  int first, second;
};

/// Sums over pairs, each counted once over all ranks.
struct PairSums {
  double stored_normal = 0.0, stored_tangential = 0.0;                                          ///< [J]
  double viscous_loss = 0.0, friction_loss = 0.0, hysteresis_loss = 0.0, curvature_gain = 0.0;  ///< since the start [J]
  double contacts = 0.0, candidates = 0.0;

  void add(const PairChunk& chunk, double weight);
};

class RankPairs {
 public:
  /// What contacts remember goes to the atoms that this rank owns. `tags` are those of all atoms. The list stays, for a
  /// run that goes on with it.
  void stow(const RankBodies& rank, const int* tags, std::vector<StowedContacts>& atoms);

  /// A new list, from what LAMMPS found and from the driven bodies. Contacts are those that were stowed.
  /// @pre the bodies' travels are zero
  void list(const RankBodies& rank, const int* tags, std::span<const AtomPair> found, double skin,
            const std::vector<StowedContacts>& atoms);

  /// Forces between the bodies. Returns the chunk in which something went wrong, or null.
  const PairChunk* evaluate(const RankBodies& rank);

  PairSums sums() const;
  std::span<const PairChunk> chunks() const { return chunks_; }
  /// Half for pairs that two ranks evaluate.
  double weight(std::size_t chunk) const { return chunk < shared_ ? 1.0 : 0.5; }

 private:
  /// A pair that did not touch, kept on this rank from list to list.
  struct Sleeper {
    std::uint64_t key;  ///< of both bodies
    FarCache cache;
    double quiet;  ///< [m] that both may still travel
  };

  /// A chunk whose bodies have no places yet: its pairs' bodies stand beside it.
  struct Draft {
    PairChunk chunk;
    std::vector<BodyPair> far, contacts;
  };

  void add(const RankBodies& rank, BodyPair pair, const int* tags, const StowedContacts& stowed, std::size_t from);
  /// The last chunk of the group that has room, none before `from`.
  Draft& open_draft(const PairGroup& group, std::size_t from);
  void finish(Draft& draft);

  std::vector<PairChunk> chunks_;
  std::size_t shared_ = 0;           ///< chunks from here on hold pairs with ghosts
  std::vector<Sleeper> sleepers_;    ///< by key
  PairSums gone_;                    ///< losses in chunks that are no more
  std::vector<Draft> drafts_;        ///< while a list is made
  std::vector<std::int32_t> place_;  ///< of each body in the chunk that is being finished, or −1
  ChunkScratch scratch_;
};

}  // namespace osculate::lammps
