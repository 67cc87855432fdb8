#pragma once
// The first half of a step for many bodies side by side: half a kick, then the way to the end of the step.

#include <cstddef>
#include <vector>

#include "dynamics/kinematics.hpp"
#include "osculate/dynamics/bodies.hpp"

namespace osculate {

struct MoveStep {
  double time_step;  ///< [s]
  Vec3 gravity;      ///< [m/s²]
};

/// Moves bodies begin … end − 1 as if all were free and writes their records; what this makes of driven bodies is to be
/// overwritten. A body's numbers do not depend on its neighbours.
/// @param radius  of the bounding spheres [m]
/// @param way     what any point of a body has moved at most [m]
void move_bodies(const MoveStep& step, std::size_t begin, std::size_t end, Bodies& bodies, Kinematics& kinematics,
                 const std::vector<double>& radius, std::vector<double>& way);

}  // namespace osculate
