#include "app/wall_patch.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "osculate/core/error.hpp"

namespace osculate::app {
namespace {

struct SurfacePoint {
  Vec3 position;
  Vec3 normal;
};

/// From two coordinates in [−1, 1] to the wall.
using WallMap = std::function<SurfacePoint(double s, double t)>;

WallMap map_of(const HalfSpace&, const Vec3& point, double reach) {
  return [=](double s, double t) {
    return SurfacePoint{Vec3(point.x() + s * reach, point.y() + t * reach, 0.0), Vec3::UnitZ()};
  };
}

WallMap map_of(const Cylinder& cylinder, const Vec3& point, double reach) {
  const double middle = std::atan2(point.y(), point.x());
  const double half_angle = std::min(std::numbers::pi, reach / cylinder.radius);
  const double outward = cylinder.solid == Cylinder::Solid::inside ? 1.0 : -1.0;
  return [=](double s, double t) {
    const double angle = middle + s * half_angle;
    const Vec3 radial(std::cos(angle), std::sin(angle), 0.0);
    return SurfacePoint{cylinder.radius * radial + Vec3(0.0, 0.0, point.z() + t * reach), outward * radial};
  };
}

WallMap map_of(const SphereContainer& container, const Vec3& point, double reach) {
  const Vec3 middle = point.norm() > 0.0 ? Vec3(point.normalized()) : Vec3::UnitZ();
  const Vec3 across = middle.unitOrthogonal();
  const Vec3 along = middle.cross(across);
  // Half the sphere at most: the square's corners are √2 further out than its sides.
  const double half_angle = std::min(0.5 * std::numbers::pi, reach / container.radius);
  return [=](double s, double t) {
    const double angle = half_angle * std::hypot(s, t);
    const Vec3 side = angle > 0.0 ? Vec3((s * across + t * along).normalized()) : across;
    const Vec3 radial = std::cos(angle) * middle + std::sin(angle) * side;
    return SurfacePoint{container.radius * radial, -radial};
  };
}

template <class Particle>
WallMap map_of(const Particle&, const Vec3&, double) {
  throw InputError("wall patch", "a particle", "a wall");
}

}  // namespace

TriangleMesh wall_patch(const Shape& wall, const Vec3& point_b, double reach) {
  constexpr int cells = 48;
  const WallMap map = std::visit([&](const auto& one) { return map_of(one, point_b, reach); }, wall);
  TriangleMesh mesh;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const SurfacePoint at = map(2.0 * i / cells - 1.0, 2.0 * j / cells - 1.0);
      mesh.vertices.push_back(at.position);
      mesh.normals.push_back(at.normal);
    }
  }
  const auto turned_outward = [&](std::array<int, 3> triangle) {
    const auto vertex = [&](std::size_t k) { return mesh.vertices[static_cast<std::size_t>(triangle[k])]; };
    const Vec3 normal = (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0));
    if (normal.dot(mesh.normals[static_cast<std::size_t>(triangle[0])]) < 0.0) std::swap(triangle[1], triangle[2]);
    return triangle;
  };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const int corner = i * (cells + 1) + j;
      mesh.triangles.push_back(turned_outward({corner, corner + cells + 1, corner + 1}));
      mesh.triangles.push_back(turned_outward({corner + 1, corner + cells + 1, corner + cells + 2}));
    }
  }
  return mesh;
}

}  // namespace osculate::app
