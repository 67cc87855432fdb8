#pragma once
// The second half of a step for many bodies side by side: forces and torques add up, and what is left of the kick.

#include <cstddef>

#include "dynamics/pair_list.hpp"
#include "osculate/dynamics/bodies.hpp"

namespace osculate {

struct Kick {
  double time;   ///< [s]
  Vec3 gravity;  ///< [m/s²]
};

/// Adds up the wrenches on bodies begin … end − 1 and gives the free ones their kick. A body's numbers do not depend on
/// its neighbours.
void kick_bodies(const Kick& kick, std::size_t begin, std::size_t end, const PairList& pairs, Bodies& bodies);

}  // namespace osculate
