#include "osculate/geometry/common_normal.hpp"

#include <array>
#include <tuple>
#include <utility>

#include "geometry/pair_job.hpp"
#include "osculate/core/error.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate {
namespace {

bool is_potential(const Shape& shape) {
  return std::holds_alternative<PotentialParticle>(shape);
}

bool is_finite(const Pose& pose) {
  return pose.position.allFinite() && pose.orientation.coeffs().allFinite();
}

/// The order in which a pair is computed: superquadrics, potential particles, walls.
int rank(const Shape& shape) {
  if (!is_particle(shape)) return 2;
  return is_potential(shape) ? 1 : 0;
}

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

bool precedes(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
  if (rank(a) != rank(b)) return rank(a) < rank(b);
  if (!is_potential(a)) return false;  // superquadrics keep their own order
  return precedes(std::get<PotentialParticle>(a), pose_a, std::get<PotentialParticle>(b), pose_b);
}

void swap_bodies(ContactCache& cache) {
  std::swap(cache.point_1, cache.point_2);
  std::swap(cache.normal_1, cache.normal_2);
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
          throw InputError("common normal", std::string("a ") + std::string(kind(s)), "a superquadric");
      },
      shape);
}

ContactGeometry superquadric_contact(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2,
                                     ContactCache& cache, Gap gap) {
  SuperquadricPairs pairs;
  ContactCaches caches;
  ContactColumns contacts;
  pairs.resize(1);
  caches.resize(1);
  pairs.set(0, superquadric_of(shape_1), pose_1, superquadric_of(shape_2), pose_2);
  caches.set(0, cache);
  common_normals(pairs, caches, contacts, gap);
  cache = caches.get(0);
  return contacts.get(0);
}

/// Bodies in their order.
ContactGeometry ordered_contact(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2,
                                ContactCache& cache, Gap gap) {
  if (!is_particle(shape_1)) {
    throw InputError("common normal",
                     "two walls (" + std::string(kind(shape_1)) + " and " + std::string(kind(shape_2)) + ")",
                     "at least one particle");
  }
  if (!is_finite(pose_1) || !is_finite(pose_2)) {
    cache = {};
    return {};
  }
  if (rank(shape_2) == 0) return superquadric_contact(shape_1, pose_1, shape_2, pose_2, cache, gap);
  ContactGeometry contact;
  std::array<PairJob, 1> job{PairJob{&shape_1, pose_1, &shape_2, pose_2, &cache, &contact}};
  if (is_potential(shape_2))
    solve_potential_pairs(job, gap);
  else
    solve_wall_pairs(job, gap);
  return contact;
}

}  // namespace

ContactGeometry common_normal(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2,
                              ContactCache& cache, Gap gap) {
  if (!precedes(shape_2, pose_2, shape_1, pose_1))
    return ordered_contact(shape_1, pose_1, shape_2, pose_2, cache, gap);
  swap_bodies(cache);
  ContactGeometry contact = ordered_contact(shape_2, pose_2, shape_1, pose_1, cache, gap);
  swap_bodies(cache);
  swap_bodies(contact);
  return contact;
}

ContactGeometry common_normal(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2) {
  ContactCache cache;
  return common_normal(shape_1, pose_1, shape_2, pose_2, cache);
}

}  // namespace osculate
