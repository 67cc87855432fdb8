// Vectors and quaternions that stand one after another in memory, side by side in the lanes of a batch.
#if defined(OSCULATE_DYNAMICS_VECTOR_ROWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_DYNAMICS_VECTOR_ROWS_INL
#undef OSCULATE_DYNAMICS_VECTOR_ROWS_INL
#else
#define OSCULATE_DYNAMICS_VECTOR_ROWS_INL
#endif

#include <algorithm>
#include <cstddef>

#include "dynamics/rigid_rotation-inl.hpp"
#include "osculate/core/types.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// Up to one batch of rows of N doubles each, to be read as whole batches: those beyond the last one repeat it.
template <std::size_t N>
class PaddedRows {
 public:
  HWY_INLINE PaddedRows(const double* first, std::size_t count) : rows_(first) {
    if (count >= lanes<Batch>()) return;
    for (std::size_t i = 0; i < lanes<Batch>(); ++i)
      std::copy_n(first + N * std::min(i, count - 1), N, padded_ + N * i);
    rows_ = padded_;
  }
  HWY_INLINE const double* get() const { return rows_; }

 private:
  const double* rows_;
  HWY_ALIGN double padded_[N * lanes<Batch>()];
};

HWY_INLINE V3<Batch> read(const Vec3* from, std::size_t count) {
  V3<Batch> v;
  hn::LoadInterleaved3(Tag(), PaddedRows<3>(from->data(), count).get(), v.x.v, v.y.v, v.z.v);
  return v;
}
HWY_INLINE QuatOf<Batch> read(const Quat* from, std::size_t count) {
  QuatOf<Batch> q;
  hn::LoadInterleaved4(Tag(), PaddedRows<4>(from->coeffs().data(), count).get(), q.v.x.v, q.v.y.v, q.v.z.v, q.w.v);
  return q;
}
HWY_INLINE void write(const V3<Batch>& v, Vec3* to, std::size_t count) {
  if (count == lanes<Batch>()) return hn::StoreInterleaved3(v.x.v, v.y.v, v.z.v, Tag(), to->data());
  HWY_ALIGN double rows[3 * lanes<Batch>()];
  hn::StoreInterleaved3(v.x.v, v.y.v, v.z.v, Tag(), rows);
  std::copy_n(rows, 3 * count, to->data());
}
HWY_INLINE void write(const QuatOf<Batch>& q, Quat* to, std::size_t count) {
  if (count == lanes<Batch>())
    return hn::StoreInterleaved4(q.v.x.v, q.v.y.v, q.v.z.v, q.w.v, Tag(), to->coeffs().data());
  HWY_ALIGN double rows[4 * lanes<Batch>()];
  hn::StoreInterleaved4(q.v.x.v, q.v.y.v, q.v.z.v, q.w.v, Tag(), rows);
  std::copy_n(rows, 4 * count, to->coeffs().data());
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
