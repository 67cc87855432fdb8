#include "tools/convex_hull.hpp"

#include "osculate/core/error.hpp"

namespace osculate::tools {

bool can_find_convex_hulls() {
  return false;
}

ConvexHull convex_hull(std::span<const Vec3>) {
  throw InputError(
      "convex hull", "found a program built without the shape tools",
      "a build with OSCULATE_WITH_CGAL=ON and CGAL installed, or face planes instead of a polyhedron file");
}

}  // namespace osculate::tools
