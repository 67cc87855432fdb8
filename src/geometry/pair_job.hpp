#pragma once
// The work of the narrow phase for pairs that are not both superquadrics: one job a pair, in a fixed order of the
// bodies.

#include <span>

#include "osculate/geometry/common_normal.hpp"

namespace osculate {

/// One pair, and where its answer goes. The cache is read and brought up to date.
struct PairJob {
  const Shape* shape_1;
  Pose pose_1;
  const Shape* shape_2;
  Pose pose_2;
  ContactCache* cache;
  ContactGeometry* contact;
};

/// Any particle (body 1) against a potential particle (body 2).
void solve_potential_pairs(std::span<PairJob> jobs, Gap gap);

/// Any particle (body 1) against a wall (body 2).
void solve_wall_pairs(std::span<PairJob> jobs, Gap gap);

}  // namespace osculate
