#pragma once
// Searches over all directions that bound what they did not see.

#include <functional>

#include "osculate/core/types.hpp"

namespace osculate {

/// An upper bound of the largest |x| in a convex body given by its support points, by branch and bound over spherical
/// triangles: a point at angle ≤ α from u has |x| ≤ h(u)/cos α. Tight to 1e-9, or to what 4000 support points allow.
double largest_radius(const std::function<Vec3(const Vec3&)>& support_point);

}  // namespace osculate
