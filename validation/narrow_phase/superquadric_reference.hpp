#pragma once
// The depth of two superquadrics found the slow and plain way, to judge the narrow phase by.
// It shares no formula with the library: the support function is written out in long double, its minimum is sought from
// several hundred starts by quasi-Newton descent, and no step relies on a Hessian, so that kinks (faces of n = 64,
// needles of n = 1.05) stop it no more than smooth bodies do. 4 to 20 ms a pair.

#include <limits>

#include "osculate/core/types.hpp"
#include "osculate/shapes/superquadric.hpp"

namespace osculate::validation {

/// A local minimum of g(u) = h1(u) + h2(−u) − u·(c2 − c1) over unit u.
struct Minimum {
  Vec3 normal = Vec3::Zero();  ///< u, unit, from body 1 to body 2, world frame
  double depth = 0.0;          ///< g(u) [m]; negative is a gap
  Vec3 on_1 = Vec3::Zero();    ///< support point of body 1 along u [m], world frame
  Vec3 on_2 = Vec3::Zero();    ///< support point of body 2 along −u [m]
  double residual = 0.0;  ///< |tangential part of on_1 − on_2| [m]; stays large on kinks, where g still is minimal
};

struct Depth {
  Minimum minimum;  ///< the global minimum of g: its depth is the penetration depth
  double next = std::numeric_limits<double>::infinity();  ///< g at the next best local minimum [m]; ∞ if none was found
};

/// The global minimum of g as far as the multi-start reaches. Depth to about 1e-17 of the larger body.
Depth reference_depth(const Superquadric& shape_1, const Pose& pose_1, const Superquadric& shape_2, const Pose& pose_2);

/// g(u) in the direction `normal`, in long double: an upper bound of the depth whatever the direction.
double overlap_along(const Vec3& normal, const Superquadric& shape_1, const Pose& pose_1, const Superquadric& shape_2,
                     const Pose& pose_2);

}  // namespace osculate::validation
