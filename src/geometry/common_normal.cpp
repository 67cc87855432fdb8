#include "osculate/geometry/common_normal.hpp"

#include <array>

#include "geometry/pair_job.hpp"
#include "geometry/pair_order.hpp"
#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate {
namespace {

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

ContactGeometry ordered_contact(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2,
                                ContactCache& cache, Gap gap) {
  require_particle(shape_1, shape_2);
  if (!is_finite(pose_1) || !is_finite(pose_2)) {
    cache = {};
    return {};
  }
  const PairKind kind = pair_kind(shape_2);
  if (kind == PairKind::superquadrics) return superquadric_contact(shape_1, pose_1, shape_2, pose_2, cache, gap);
  ContactGeometry contact;
  std::array<PairJob, 1> job{PairJob{&shape_1, pose_1, &shape_2, pose_2, &cache, &contact}};
  kind == PairKind::potential ? solve_potential_pairs(job, gap) : solve_wall_pairs(job, gap);
  return contact;
}

}  // namespace

ContactGeometry common_normal(const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2,
                              ContactCache& cache, Gap gap) {
  if (!precedes(shape_2, pose_2, shape_1, pose_1)) return ordered_contact(shape_1, pose_1, shape_2, pose_2, cache, gap);
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
