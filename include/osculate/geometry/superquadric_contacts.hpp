#pragma once
// The narrow phase of superquadrics in bulk: many pairs at once, structure of arrays, warm state beside them.

#include <array>
#include <cstddef>
#include <vector>

#include "osculate/geometry/common_normal.hpp"

namespace osculate {

/// N columns of doubles of equal length.
template <std::size_t N>
class Columns {
 public:
  void resize(std::size_t size) {
    for (auto& column : columns_) column.resize(size);
  }
  std::size_t size() const { return columns_[0].size(); }
  double* operator[](std::size_t k) { return columns_[k].data(); }
  const double* operator[](std::size_t k) const { return columns_[k].data(); }

 private:
  std::array<std::vector<double>, N> columns_;
};

/// Pairs of superquadrics. Columns of body 1, then of body 2:
/// a, b, c [m], n1, n2, x, y, z [m], orientation w, x, y, z (unit quaternion, body → world).
struct SuperquadricPairs {
  static constexpr std::size_t per_body = 12;
  Columns<2 * per_body> columns;

  void resize(std::size_t size) { columns.resize(size); }
  std::size_t size() const { return columns.size(); }
  void set(std::size_t i, const Superquadric& shape_1, const Pose& pose_1, const Superquadric& shape_2,
           const Pose& pose_2);
};

/// A ContactCache for every pair. Columns: point 1, normal 1, point 2, normal 2, three each.
struct ContactCaches {
  std::vector<ContactCache::State> states;
  Columns<12> columns;

  /// New entries are empty.
  void resize(std::size_t size);
  std::size_t size() const { return states.size(); }
  ContactCache get(std::size_t i) const;
  void set(std::size_t i, const ContactCache& cache);
};

/// A ContactGeometry for every pair. Columns: normal (3), overlap, on_1 (3), on_2 (3), curvature 1: max, min, direction
/// of max (3), curvature 2: the same, R_i, R_j, major axis (3).
struct ContactColumns {
  std::vector<ContactStatus> statuses;
  Columns<25> columns;

  void resize(std::size_t size);
  std::size_t size() const { return statuses.size(); }
  ContactGeometry get(std::size_t i) const;
};

/// The contacts of all pairs; `contacts` and `caches` are resized to fit. Each pair's answer is bit-identical whatever
/// pairs stand beside it. Pairs whose cache is empty start cold.
void common_normals(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts,
                    Gap gap = Gap::resolve);

/// The same, one pair after another through the same formulas in plain doubles: for comparison.
void common_normals_scalar(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts,
                           Gap gap = Gap::resolve);

/// Name of the instruction set that the batches run on ("AVX3", "AVX2", "SSE4").
const char* batch_instruction_set();

}  // namespace osculate
