#include "osculate/geometry/shape_contacts.hpp"

#include <utility>

#include "geometry/contact_rows.hpp"
#include "geometry/pair_job.hpp"
#include "geometry/pair_order.hpp"

namespace osculate {
namespace {

Pose pose_at(const Columns<2 * ShapePairs::per_pose>& columns, std::size_t first, std::size_t i) {
  const auto at = [&](std::size_t k) { return columns[first + k][i]; };
  return {Vec3(at(0), at(1), at(2)), Quat(at(3), at(4), at(5), at(6))};
}

/// What is being solved of a pair, and whether it was turned round for it.
struct Row {
  std::size_t index;
  bool swapped;
  ContactCache cache;
  ContactGeometry contact;
};

void solve_superquadrics(const std::vector<PairJob>& jobs, Gap gap) {
  SuperquadricPairs pairs;
  ContactCaches caches;
  ContactColumns contacts;
  pairs.resize(jobs.size());
  caches.resize(jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const PairJob& job = jobs[i];
    pairs.set(i, superquadric_of(*job.shape_1), job.pose_1, superquadric_of(*job.shape_2), job.pose_2);
    caches.set(i, *job.cache);
  }
  common_normals(pairs, caches, contacts, gap);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    *jobs[i].cache = caches.get(i);
    *jobs[i].contact = contacts.get(i);
  }
}

}  // namespace

void ShapePairs::resize(std::size_t size) {
  shapes_1.resize(size);
  shapes_2.resize(size);
  columns.resize(size);
}

void ShapePairs::set(std::size_t i, const Shape& shape_1, const Pose& pose_1, const Shape& shape_2,
                     const Pose& pose_2) {
  shapes_1[i] = &shape_1;
  shapes_2[i] = &shape_2;
  const auto fill = [&](std::size_t first, const Pose& pose) {
    const Quat& q = pose.orientation;
    const double values[per_pose] = {
        pose.position.x(), pose.position.y(), pose.position.z(), q.w(), q.x(), q.y(), q.z()};
    for (std::size_t k = 0; k < per_pose; ++k) columns[first + k][i] = values[k];
  };
  fill(0, pose_1);
  fill(per_pose, pose_2);
}

void common_normals(const ShapePairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap) {
  caches.resize(pairs.size());
  contacts.resize(pairs.size());
  std::vector<Row> rows(pairs.size());
  std::vector<PairJob> jobs_of[3];  // by PairKind
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Row& row = rows[i];
    row.index = i;
    PairJob job{pairs.shapes_1[i], pose_at(pairs.columns, 0, i),
                pairs.shapes_2[i], pose_at(pairs.columns, ShapePairs::per_pose, i),
                &row.cache,        &row.contact};
    row.swapped = precedes(*job.shape_2, job.pose_2, *job.shape_1, job.pose_1);
    if (row.swapped) {
      std::swap(job.shape_1, job.shape_2);
      std::swap(job.pose_1, job.pose_2);
    }
    require_particle(*job.shape_1, *job.shape_2);
    if (!is_finite(job.pose_1) || !is_finite(job.pose_2)) continue;
    row.cache = caches.get(i);
    if (row.swapped) swap_bodies(row.cache);
    jobs_of[static_cast<int>(pair_kind(*job.shape_2))].push_back(job);
  }
  solve_superquadrics(jobs_of[static_cast<int>(PairKind::superquadrics)], gap);
  solve_potential_pairs(jobs_of[static_cast<int>(PairKind::potential)], gap);
  solve_wall_pairs(jobs_of[static_cast<int>(PairKind::wall)], gap);
  for (Row& row : rows) {
    if (row.swapped) {
      swap_bodies(row.cache);
      swap_bodies(row.contact);
    }
    caches.set(row.index, row.cache);
    set_row(contacts, row.index, row.contact);
  }
}

}  // namespace osculate
