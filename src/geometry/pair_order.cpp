#include "geometry/pair_order.hpp"

#include <string>
#include <tuple>
#include <utility>

#include "osculate/core/error.hpp"

namespace osculate {
namespace {

auto numbers(const Pose& pose) {
  const Quat& q = pose.orientation;
  return std::tuple(pose.position.x(), pose.position.y(), pose.position.z(), q.w(), q.x(), q.y(), q.z());
}

auto numbers(const PotentialParticle& shape) {
  return std::tuple(shape.planes.size(), shape.sphericity, shape.edge_radius, shape.sphere_radius);
}

auto numbers(const FacePlane& plane) {
  return std::tuple(plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.distance);
}

/// Between two potential particles any fixed order will do, as long as it does not ask which was named first.
bool precedes(const PotentialParticle& a, const Pose& pose_a, const PotentialParticle& b, const Pose& pose_b) {
  if (numbers(pose_a) != numbers(pose_b)) return numbers(pose_a) < numbers(pose_b);
  if (numbers(a) != numbers(b)) return numbers(a) < numbers(b);
  for (std::size_t i = 0; i < a.planes.size(); ++i)
    if (numbers(a.planes[i]) != numbers(b.planes[i])) return numbers(a.planes[i]) < numbers(b.planes[i]);
  return false;
}

}  // namespace

PairKind pair_kind(const Shape& shape) {
  if (!is_particle(shape)) return PairKind::wall;
  return std::holds_alternative<PotentialParticle>(shape) ? PairKind::potential : PairKind::superquadrics;
}

bool is_finite(const Pose& pose) {
  return pose.position.allFinite() && pose.orientation.coeffs().allFinite();
}

bool precedes(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
  const PairKind kind_a = pair_kind(a), kind_b = pair_kind(b);
  if (kind_a != kind_b) return kind_a < kind_b;
  if (kind_a != PairKind::potential) return false;
  return precedes(std::get<PotentialParticle>(a), pose_a, std::get<PotentialParticle>(b), pose_b);
}

void require_particle(const Shape& first, const Shape& second) {
  if (is_particle(first)) return;
  throw InputError("common normal",
                   "two walls (" + std::string(kind(first)) + " and " + std::string(kind(second)) + ")",
                   "at least one particle");
}

void swap_bodies(ContactCache& cache) {
  std::swap(cache.point_1, cache.point_2);
  std::swap(cache.normal_1, cache.normal_2);
  std::swap(cache.shape_1, cache.shape_2);
}

void swap_bodies(ContactGeometry& contact) {
  contact.normal = -contact.normal;
  std::swap(contact.on_1, contact.on_2);
  std::swap(contact.curvature_1, contact.curvature_2);
}

Superquadric superquadric_of(const Shape& shape) {
  return std::visit(
      [](const auto& s) -> Superquadric {
        if constexpr (requires { as_superquadric(s); })
          return as_superquadric(s);
        else
          throw InputError("common normal", "a " + std::string(kind(s)), "a superquadric");
      },
      shape);
}

}  // namespace osculate
