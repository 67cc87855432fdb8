#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/shapes/potential_particle.hpp"

namespace osculate {
namespace {

const std::string where = "potential particle";

std::string plane_name(std::size_t index) {
  return where + ", plane " + std::to_string(index + 1);
}

std::string text(double number) {
  return std::to_string(number);
}

std::string text(const Vec3& v) {
  return "(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")";
}

bool is_positive(double number) {
  return number > 0.0 && std::isfinite(number);
}

/// A direction in which no plane bounds the body. If there is any, there is one along which two planes are parallel to
/// it, or all planes are parallel to one line.
std::optional<Vec3> open_direction(const std::vector<FacePlane>& planes) {
  constexpr double parallel = 1e-9;
  const auto is_open = [&](const Vec3& u) {
    for (const FacePlane& plane : planes) {
      if (plane.normal.dot(u) > parallel) return false;
    }
    return true;
  };
  bool any_crossing = false;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const Vec3 crossing = planes[i].normal.cross(planes[j].normal);
      if (crossing.norm() <= parallel) continue;
      any_crossing = true;
      const Vec3 u = crossing.normalized();
      if (is_open(u)) return u;
      if (is_open(-u)) return Vec3(-u);
    }
  }
  if (any_crossing) return std::nullopt;
  return planes.empty() ? Vec3(Vec3::UnitX()) : Vec3(planes.front().normal.unitOrthogonal());
}

void validate_planes(const std::vector<FacePlane>& planes) {
  constexpr double unit_tolerance = 1e-9;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const FacePlane& plane = planes[i];
    const double length = plane.normal.norm();
    if (!(std::fabs(length - 1.0) <= unit_tolerance)) {
      throw InputError(plane_name(i), "normal " + text(plane.normal) + " of length " + text(length),
                       "an outward unit normal");
    }
    if (!is_positive(plane.distance)) {
      throw InputError(plane_name(i), "distance = " + text(plane.distance) + " m",
                       "a positive, finite distance, so that the origin lies inside");
    }
  }
  if (const auto open = open_direction(planes)) {
    throw InputError(where, std::to_string(planes.size()) + " planes that leave the direction " + text(*open) + " open",
                     "planes that bound a volume");
  }
}

}  // namespace

void validate(const PotentialParticle& shape) {
  if (!(shape.sphericity > 0.0 && shape.sphericity <= 1.0)) {
    throw InputError(where, "sphericity k = " + text(shape.sphericity), "k in (0, 1]");
  }
  if (!is_positive(shape.edge_radius)) {
    throw InputError(where, "edge radius r = " + text(shape.edge_radius) + " m", "a positive, finite length");
  }
  if (!is_positive(shape.sphere_radius)) {
    throw InputError(where, "sphere radius R = " + text(shape.sphere_radius) + " m", "a positive, finite length");
  }
  validate_planes(shape.planes);

  double nearest = std::numeric_limits<double>::infinity(), furthest = 0.0;
  std::size_t nearest_plane = 0;
  for (std::size_t i = 0; i < shape.planes.size(); ++i) {
    if (shape.planes[i].distance < nearest) {
      nearest = shape.planes[i].distance;
      nearest_plane = i;
    }
    furthest = std::max(furthest, shape.planes[i].distance);
  }
  const double sphere = shape.sphere_radius / std::sqrt(shape.sphericity);
  if (shape.sphericity < 1.0 && sphere <= nearest) {
    throw InputError(plane_name(nearest_plane),
                     "a distance of " + text(nearest) + " m outside the sphere of radius R/√k = " + text(sphere) +
                         " m that holds the body, as every plane is",
                     "at least one plane that cuts the sphere (R > d √k), or k = 1 for a sphere");
  }
  constexpr double absurd = 100.0;
  const std::string in_proportion =
      "at most 100 times the furthest plane's distance, " + text(furthest) + " m (is every length in metres?)";
  if (shape.edge_radius > absurd * furthest) {
    throw InputError(where, "edge radius r = " + text(shape.edge_radius) + " m", in_proportion);
  }
  if (shape.sphere_radius > absurd * furthest) {
    throw InputError(where, "sphere radius R = " + text(shape.sphere_radius) + " m", in_proportion);
  }
}

}  // namespace osculate
