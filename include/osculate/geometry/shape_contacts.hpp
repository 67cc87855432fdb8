#pragma once
// The narrow phase of any shapes in bulk: many pairs at once, structure of arrays, warm state beside them.

#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate {

/// Pairs of shapes that live elsewhere. Columns of body 1, then of body 2: x, y, z [m], orientation w, x, y, z
/// (unit quaternion, body → world).
struct ShapePairs {
  static constexpr std::size_t per_pose = 7;
  std::vector<const Shape*> shapes_1, shapes_2;
  Columns<2 * per_pose> columns;

  void resize(std::size_t size);
  std::size_t size() const { return shapes_1.size(); }
  void set(std::size_t i, const Shape& shape_1, const Pose& pose_1, const Shape& shape_2, const Pose& pose_2);
};

/// The contacts of all pairs; `contacts` and `caches` are resized to fit. Pairs of one kind are solved side by side,
/// with the formulas of `common_normal`: the answers agree to round-off. Throws InputError for a pair of walls.
void common_normals(const ShapePairs& pairs, ContactCaches& caches, ContactColumns& contacts, Gap gap = Gap::resolve);

}  // namespace osculate
