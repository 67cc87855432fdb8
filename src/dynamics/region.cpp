#include "osculate/dynamics/region.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "osculate/core/error.hpp"

namespace osculate {
namespace {

void require(bool sound, const char* found, const char* expected) {
  if (!sound) throw InputError("region", found, expected);
}

void check(const BoxRegion& box) {
  require(box.lower.allFinite() && box.upper.allFinite() && (box.upper - box.lower).minCoeff() > 0.0,
          "a box without volume", "lower < upper in all three directions");
}
void check(const CylinderRegion& cylinder) {
  require(cylinder.base.allFinite() && cylinder.radius > 0.0 && cylinder.height > 0.0 &&
              std::isfinite(cylinder.radius + cylinder.height),
          "a cylinder without volume", "radius and height > 0");
}
void check(const SphereRegion& sphere) {
  require(sphere.centre.allFinite() && sphere.radius > 0.0 && std::isfinite(sphere.radius), "a sphere without volume",
          "radius > 0");
}

double volume_of(const BoxRegion& box) {
  return (box.upper - box.lower).prod();
}
double volume_of(const CylinderRegion& cylinder) {
  return std::numbers::pi * cylinder.radius * cylinder.radius * cylinder.height;
}
double volume_of(const SphereRegion& sphere) {
  return 4.0 / 3.0 * std::numbers::pi * sphere.radius * sphere.radius * sphere.radius;
}

double depth_in(const BoxRegion& box, const Vec3& point) {
  return std::min((point - box.lower).minCoeff(), (box.upper - point).minCoeff());
}
double depth_in(const CylinderRegion& cylinder, const Vec3& point) {
  const Vec3 x = point - cylinder.base;
  return std::min({x.z(), cylinder.height - x.z(), cylinder.radius - std::hypot(x.x(), x.y())});
}
double depth_in(const SphereRegion& sphere, const Vec3& point) {
  return sphere.radius - (point - sphere.centre).norm();
}

BoxRegion bounds_of(const BoxRegion& box) {
  return box;
}
BoxRegion bounds_of(const CylinderRegion& cylinder) {
  const Vec3 side(cylinder.radius, cylinder.radius, 0.0);
  return {.lower = cylinder.base - side, .upper = cylinder.base + side + cylinder.height * Vec3::UnitZ()};
}
BoxRegion bounds_of(const SphereRegion& sphere) {
  const Vec3 side = Vec3::Constant(sphere.radius);
  return {.lower = sphere.centre - side, .upper = sphere.centre + side};
}

}  // namespace

void validate(const Region& region) {
  std::visit([](const auto& one) { check(one); }, region);
}

double volume(const Region& region) {
  return std::visit([](const auto& one) { return volume_of(one); }, region);
}

double depth(const Region& region, const Vec3& point) {
  return std::visit([&](const auto& one) { return depth_in(one, point); }, region);
}

bool contains(const Region& region, const Vec3& point) {
  return depth(region, point) >= 0.0;
}

BoxRegion bounds(const Region& region) {
  return std::visit([](const auto& one) { return bounds_of(one); }, region);
}

}  // namespace osculate
