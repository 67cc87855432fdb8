#pragma once
// From points to the face planes of their convex hull. Needs CGAL, whose hull is under the GPL: a component of its own,
// which can be left out (OSCULATE_WITH_CGAL=OFF).

#include <span>
#include <vector>

#include "osculate/core/types.hpp"
#include "osculate/shapes/potential_particle.hpp"

namespace osculate::tools {

/// The convex hull of points, seen from its centroid.
struct ConvexHull {
  std::vector<FacePlane> planes;  ///< outward; distances from the centroid [unit of the points]
  Vec3 centroid;                  ///< of the hull's volume, in the frame of the points
  double volume;
};

/// Whether this build can find hulls.
bool can_find_convex_hulls();

/// The hull with facets that lie in one plane within 1e-6 of its size merged: largest facets first, each plane touching
/// the hull from outside. Throws InputError unless the points span a volume, or if the component was not built.
ConvexHull convex_hull(std::span<const Vec3> points);

}  // namespace osculate::tools
