#pragma once
// The narrow phase of superquadrics in bulk: many pairs at once, structure of arrays, warm state beside them.

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "osculate/core/aligned_allocator.hpp"
#include "osculate/geometry/common_normal.hpp"

namespace osculate {

/// N columns of doubles of equal length, in one piece of memory. New entries are zero.
template <std::size_t N>
class Columns {
 public:
  void resize(std::size_t size) {
    if (size > stride_) {
      Columns wider;
      // Whole cache lines, an odd number of them: columns that start 4 KiB apart would crowd each other out.
      const std::size_t lines = (std::max(size, stride_ + stride_ / 2) + 7) / 8;
      wider.stride_ = 8 * (lines | 1U);
      wider.values_.resize(N * wider.stride_);
      for (std::size_t k = 0; k < N; ++k) std::copy_n((*this)[k], size_, wider[k]);
      *this = std::move(wider);
    }
    for (std::size_t k = 0; k < N && size < size_; ++k) std::fill((*this)[k] + size, (*this)[k] + size_, 0.0);
    size_ = size;
  }
  std::size_t size() const { return size_; }
  double* operator[](std::size_t k) { return values_.data() + k * stride_; }
  const double* operator[](std::size_t k) const { return values_.data() + k * stride_; }

 private:
  std::size_t size_ = 0, stride_ = 0;
  std::vector<double, AlignedAllocator<double>> values_;
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

/// A ContactCache for every pair. Columns, three each: point 1, normal 1, point 2, normal 2, shape 1 and shape 2, which
/// share theirs: they only predict a step, so that floats do, two in the room of a double.
struct ContactCaches {
  static constexpr std::size_t width = 15;
  std::vector<ContactCache::State> states;
  Columns<width> columns;

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

/// Which curvatures are worked out.
enum class Curvatures {
  all,      ///< each body's own principal curvatures, and the relative ones
  relative  ///< R_i, R_j and the major axis, all that a force law asks for, as they are within 1e-8 of a body's size
            ///< about the contact; that itself is found as exactly as ever. The bodies' own columns are left alone.
};

/// The contacts of all pairs; `contacts` and `caches` are resized to fit. Each pair's answer is bit-identical whatever
/// pairs stand beside it. Pairs whose cache is empty start cold.
void common_normals(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts,
                    Gap gap = Gap::resolve, Curvatures curvatures = Curvatures::all);

/// The same, one pair after another through the same formulas in plain doubles: for comparison.
void common_normals_scalar(const SuperquadricPairs& pairs, ContactCaches& caches, ContactColumns& contacts,
                           Gap gap = Gap::resolve, Curvatures curvatures = Curvatures::all);

/// Name of the instruction set that the batches run on ("AVX3", "AVX2", "SSE4").
const char* batch_instruction_set();

}  // namespace osculate
