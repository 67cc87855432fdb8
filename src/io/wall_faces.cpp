#include "io/wall_faces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace osculate::io {
namespace {

/// A plane that bounds the space n·x ≥ d, and what it stands for.
struct Cut {
  Vec3 normal;
  double distance;
  std::optional<std::size_t> wall;  ///< nothing: a side of the box
};

struct Side {
  std::vector<Vec3> corners;  ///< counter-clockwise seen from inside
  Vec3 normal;                ///< inwards
  std::optional<std::size_t> wall;
};

/// A convex body by its sides.
using Polyhedron = std::vector<Side>;

/// The part of a polygon in n·x ≥ d.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const Cut& cut, double rounding) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double above_a = cut.normal.dot(a) - cut.distance, above_b = cut.normal.dot(b) - cut.distance;
    if (above_a >= -rounding) kept.push_back(a);
    if ((above_a > rounding && above_b < -rounding) || (above_a < -rounding && above_b > rounding)) {
      kept.push_back(a + (b - a) * (above_a / (above_a - above_b)));
    }
  }
  return kept;
}

/// Points of a plane in the order in which they go around their middle, doubles removed.
std::vector<Vec3> ordered(std::vector<Vec3> points, const Vec3& normal, double rounding) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  const Vec3 side = normal.unitOrthogonal(), other = normal.cross(side);
  const auto angle = [&](const Vec3& p) { return std::atan2((p - middle).dot(other), (p - middle).dot(side)); };
  std::ranges::sort(points, {}, angle);
  std::vector<Vec3> once;
  for (const Vec3& p : points) {
    if (once.empty() || (p - once.back()).norm() > rounding) once.push_back(p);
  }
  if (once.size() > 1 && (once.front() - once.back()).norm() <= rounding) once.pop_back();
  return once;
}

void cut(Polyhedron& body, const Cut& plane, double rounding) {
  Polyhedron left;
  std::vector<Vec3> rim;
  for (const Side& side : body) {
    const std::vector<Vec3> corners = clipped(side.corners, plane, rounding);
    for (const Vec3& corner : corners) {
      if (std::fabs(plane.normal.dot(corner) - plane.distance) <= 2.0 * rounding) rim.push_back(corner);
    }
    if (corners.size() >= 3) left.push_back({corners, side.normal, side.wall});
  }
  const std::vector<Vec3> face = ordered(rim, plane.normal, 10.0 * rounding);
  if (face.size() >= 3) {
    // A side of the box in the plane of a wall gives way to it.
    std::erase_if(left, [&](const Side& side) {
      return side.normal.dot(plane.normal) > 1.0 - 1e-9 &&
             std::fabs(plane.normal.dot(side.corners.front()) - plane.distance) <= 4.0 * rounding;
    });
    left.push_back({face, plane.normal, plane.wall});
  }
  body = std::move(left);
}

Polyhedron box_sides(const Box& box) {
  const Vec3 &l = box.lower, &u = box.upper;
  const auto corner = [&](int x, int y, int z) {
    return Vec3(x == 0 ? l.x() : u.x(), y == 0 ? l.y() : u.y(), z == 0 ? l.z() : u.z());
  };
  Polyhedron sides;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int end : {0, 1}) {
      std::vector<Vec3> corners;
      for (const auto& [s, t] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        corners.push_back(axis == 0 ? corner(end, s, t) : axis == 1 ? corner(t, end, s) : corner(s, t, end));
      }
      if (end == 1) std::ranges::reverse(corners);
      sides.push_back({corners, (end == 0 ? 1.0 : -1.0) * Vec3::Unit(axis), std::nullopt});
    }
  }
  return sides;
}

Cut plane_at(const Pose& pose, const Vec3& point_b, const Vec3& normal_b, std::size_t wall) {
  const Vec3 normal = pose.rotate_to_world(normal_b);
  return {normal, normal.dot(pose.to_world(point_b)), wall};
}

/// The planes that stand for a wall: none for what bounds no space.
std::vector<Cut> planes_of(const PlacedShape& placed, std::size_t wall, int around) {
  if (std::holds_alternative<HalfSpace>(placed.shape)) {
    return {plane_at(placed.pose, Vec3::Zero(), Vec3::UnitZ(), wall)};
  }
  std::vector<Cut> planes;
  const auto tangent = [&](double radius, const Vec3& outwards) {
    planes.push_back(plane_at(placed.pose, radius * outwards, -outwards, wall));
  };
  const auto angle = [&](int i) { return 2.0 * std::numbers::pi * i / around; };
  if (const auto* cylinder = std::get_if<Cylinder>(&placed.shape);
      cylinder != nullptr && cylinder->solid == Cylinder::Solid::outside) {
    for (int i = 0; i < around; ++i) tangent(cylinder->radius, {std::cos(angle(i)), std::sin(angle(i)), 0.0});
  }
  if (const auto* sphere = std::get_if<SphereContainer>(&placed.shape)) {
    const int rings = around / 2;
    for (int j = 0; j <= rings; ++j) {
      const double polar = std::numbers::pi * j / rings;
      const bool at_pole = j == 0 || j == rings;
      for (int i = 0; i < (at_pole ? 1 : around); ++i) {
        tangent(sphere->radius,
                {std::sin(polar) * std::cos(angle(i)), std::sin(polar) * std::sin(angle(i)), std::cos(polar)});
      }
    }
  }
  return planes;
}

/// The wall's normal towards the particles at one of its points.
Vec3 normal_at(const PlacedShape& wall, const Vec3& point) {
  const Vec3 at = wall.pose.to_body(point);
  const Vec3 normal_b = std::holds_alternative<HalfSpace>(wall.shape)  ? Vec3(Vec3::UnitZ())
                        : std::holds_alternative<Cylinder>(wall.shape) ? Vec3(-Vec3(at.x(), at.y(), 0.0).normalized())
                                                                       : Vec3(-at.normalized());
  return wall.pose.rotate_to_world(normal_b);
}

}  // namespace

WallSurface wall_surface(const std::vector<PlacedShape>& walls, const Box& box, int around) {
  const double rounding = 1e-9 * (box.upper - box.lower).norm();
  Polyhedron space = box_sides(box);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (const Cut& plane : planes_of(walls[w], w, around)) cut(space, plane, rounding);
  }
  WallSurface surface;
  for (const Side& side : space) {
    if (!side.wall) continue;
    WallFace face{side.corners, {}, *side.wall};
    for (const Vec3& corner : side.corners) face.normals.push_back(normal_at(walls[*side.wall], corner));
    surface.faces.push_back(std::move(face));
  }
  const auto lies_on = [&](const Side& side, const Vec3& point) {
    return std::fabs(side.normal.dot(point - side.corners.front())) <= 10.0 * rounding;
  };
  for (std::size_t i = 0; i < space.size(); ++i) {
    const Side& side = space[i];
    if (!side.wall) continue;
    for (std::size_t k = 0; k < side.corners.size(); ++k) {
      const Vec3 &from = side.corners[k], &to = side.corners[(k + 1) % side.corners.size()];
      const auto other = std::ranges::find_if(
          space, [&](const Side& next) { return &next != &side && lies_on(next, from) && lies_on(next, to); });
      const bool between_own = other != space.end() && other->wall == side.wall;
      // Once for both sides.
      const bool drawn_before = other != space.end() && other->wall && other - space.begin() < std::ptrdiff_t(i);
      if (!between_own && !drawn_before) surface.edges.push_back({from, to});
    }
  }
  return surface;
}

}  // namespace osculate::io
