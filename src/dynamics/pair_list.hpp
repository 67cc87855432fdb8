#pragma once
// All pairs of bodies near each other, in chunks.

#include <cstdint>
#include <vector>

#include "dynamics/chunk_forces.hpp"
#include "dynamics/pair_chunk.hpp"
#include "dynamics/parallel.hpp"

namespace osculate {

/// Where a body finds a part of the force on it.
struct Incidence {
  std::uint32_t chunk;
  std::uint32_t place;  ///< among the chunk's bodies
};

struct PairList {
  std::vector<PairChunk> chunks;      ///< groups in order
  std::vector<std::uint64_t> first;   ///< of each body's incidences; one more than bodies
  std::vector<Incidence> incidences;  ///< of each body in the order of the chunks
  // Of chunks that are no more [J].
  double viscous_loss = 0.0, friction_loss = 0.0, hysteresis_loss = 0.0, curvature_gain = 0.0;
};

/// The pairs that may touch while no body has moved further than its skin in `kinematics`. What `before` knows of a
/// pair is kept; its travels are those in `kinematics`, which count from zero afterwards.
PairList make_pair_list(PairList&& before, const World& world, const Bodies& bodies, const Kinematics& kinematics,
                        Threads& threads);

/// Fills first and incidences from the chunks.
void index_bodies(PairList& list, std::size_t bodies);

}  // namespace osculate
