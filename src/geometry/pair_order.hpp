#pragma once
// The order in which the bodies of a pair are computed, so that swapping them swaps the answer exactly.

#include "osculate/geometry/common_normal.hpp"

namespace osculate {

/// What a pair is, by its second body: superquadrics come first, then potential particles, then walls.
enum class PairKind : int { superquadrics, potential, wall };
PairKind pair_kind(const Shape& shape);

bool is_finite(const Pose& pose);

/// True if a pair must be computed with `a` first. Superquadrics keep an order of their own.
bool precedes(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b);

/// Throws InputError if the first of an ordered pair is a wall: then both are.
void require_particle(const Shape& first, const Shape& second);

void swap_bodies(ContactCache& cache);
void swap_bodies(ContactGeometry& contact);

/// Superquadrics, ellipsoids and spheres; throws InputError for others.
Superquadric superquadric_of(const Shape& shape);

}  // namespace osculate
