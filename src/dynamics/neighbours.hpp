#pragma once
// The broad phase: which balls are near each other.

#include <cstdint>
#include <span>
#include <vector>

#include "osculate/dynamics/periodic_box.hpp"

namespace osculate {

struct Ball {
  Vec3 centre;    ///< [m]
  double radius;  ///< > 0 [m]
};

/// Indices, first < second.
struct BodyPair {
  std::int32_t first;
  std::int32_t second;
  friend auto operator<=>(const BodyPair&, const BodyPair&) = default;
};

/// All pairs of balls that touch or overlap, each once, in an order that only the balls decide. Balls of a size share a
/// grid, one for every factor of two; a ball looks in its own grid and in the coarser ones.
/// @pre In a periodic box no two balls touch through two images: lengths > 2 (r_1 + r_2).
std::vector<BodyPair> touching_balls(std::span<const Ball> balls, const PeriodicBox& box);

}  // namespace osculate
