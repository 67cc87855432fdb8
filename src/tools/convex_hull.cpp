#include "tools/convex_hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate::tools {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Facet = std::array<Vec3, 3>;

constexpr double coplanar = 1e-6;  // of the hull's size: well above single-precision STL, well below any real bevel

Vec3 area_vector(const Facet& facet) {
  return 0.5 * (facet[1] - facet[0]).cross(facet[2] - facet[0]);
}

std::vector<Facet> hull_facets(std::span<const Vec3> points) {
  std::vector<Kernel::Point_3> cloud;
  cloud.reserve(points.size());
  for (const Vec3& point : points) cloud.emplace_back(point.x(), point.y(), point.z());
  Mesh mesh;
  CGAL::convex_hull_3(cloud.begin(), cloud.end(), mesh);

  std::vector<Facet> facets;
  for (const auto face : mesh.faces()) {
    Facet facet;
    std::size_t corner = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      const auto& at = mesh.point(vertex);
      facet[corner++] = Vec3(at.x(), at.y(), at.z());
    }
    facets.push_back(facet);
  }
  return facets;
}

}  // namespace

bool can_find_convex_hulls() {
  return true;
}

ConvexHull convex_hull(std::span<const Vec3> points) {
  const std::string found = "found " + std::to_string(points.size()) + " points that span no volume";
  const std::string expected = "points of a solid: at least four that do not lie in one plane";
  if (points.size() < 4) throw InputError("convex hull", found, expected);

  Vec3 low = points.front(), high = points.front();
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double size = (high - low).norm();
  const Vec3 inside = 0.5 * (low + high);

  std::vector<Facet> facets = hull_facets(points);
  ConvexHull hull{{}, Vec3::Zero(), 0.0};
  for (const Facet& facet : facets) {
    const double tetrahedron = (facet[0] - inside).dot(area_vector(facet)) / 3.0;
    hull.volume += tetrahedron;
    hull.centroid += tetrahedron * 0.25 * (facet[0] + facet[1] + facet[2] - 3.0 * inside);
  }
  if (facets.size() < 4 || !(hull.volume > coplanar * size * size * size)) {
    throw InputError("convex hull", found, expected);
  }
  hull.centroid = inside + hull.centroid / hull.volume;

  std::sort(facets.begin(), facets.end(), [](const Facet& first, const Facet& second) {
    return area_vector(first).squaredNorm() > area_vector(second).squaredNorm();
  });
  for (const Facet& facet : facets) {
    const auto holds_facet = [&](const FacePlane& plane) {
      return std::all_of(facet.begin(), facet.end(), [&](const Vec3& corner) {
        return plane.normal.dot(corner - hull.centroid) > plane.distance - coplanar * size;
      });
    };
    if (std::any_of(hull.planes.begin(), hull.planes.end(), holds_facet)) continue;
    const Vec3 normal = area_vector(facet).normalized();
    double distance = normal.dot(facet[0] - hull.centroid);
    for (const Vec3& point : points) distance = std::max(distance, normal.dot(point - hull.centroid));
    hull.planes.push_back({normal, distance});
  }
  return hull;
}

}  // namespace osculate::tools
