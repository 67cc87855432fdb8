#include "osculate/shapes/walls.hpp"

#include <cmath>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate {
namespace {

void require_radius(double radius, const std::string& where) {
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw InputError(where, "radius = " + std::to_string(radius) + " m", "a positive, finite length");
  }
}

}  // namespace

void validate(const HalfSpace&) {}

void validate(const Cylinder& wall) {
  require_radius(wall.radius, "cylinder");
}

void validate(const SphereContainer& wall) {
  require_radius(wall.radius, "sphere container");
}

WallDistance signed_distance(const HalfSpace&, const Vec3& x) {
  return {x.z(), Vec3::UnitZ()};
}

WallDistance signed_distance(const Cylinder& wall, const Vec3& x) {
  const double radius = std::hypot(x.x(), x.y());
  const Vec3 radial = radius > 0.0 ? Vec3(x.x() / radius, x.y() / radius, 0.0) : Vec3(Vec3::UnitX());
  const double beyond = radius - wall.radius;
  return wall.solid == Cylinder::Solid::inside ? WallDistance{beyond, radial}
                                               : WallDistance{-beyond, radius > 0.0 ? Vec3(-radial) : radial};
}

WallDistance signed_distance(const SphereContainer& wall, const Vec3& x) {
  const double radius = x.stableNorm();
  return {wall.radius - radius, radius > 0.0 ? Vec3(-x / radius) : Vec3(Vec3::UnitX())};
}

}  // namespace osculate
