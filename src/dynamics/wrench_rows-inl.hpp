// Forces and torques of a batch, one row each like a Wrench's.
#if defined(OSCULATE_DYNAMICS_WRENCH_ROWS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_DYNAMICS_WRENCH_ROWS_INL
#undef OSCULATE_DYNAMICS_WRENCH_ROWS_INL
#else
#define OSCULATE_DYNAMICS_WRENCH_ROWS_INL
#endif

#include <cstddef>
#include <tuple>

#include "core/transpose-inl.hpp"
#include "core/vector-inl.hpp"
#include "dynamics/pair_chunk.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

struct WrenchColumns {
  V3<Batch> force, torque;
};

class WrenchRows {
 public:
  /// Zeros.
  HWY_INLINE WrenchRows() : rows_{} {}
  HWY_INLINE explicit WrenchRows(const WrenchColumns& of) {
    const Batch zero(0.0);
    const auto& [f, t] = of;
    const Batch columns[numbers] = {f.x, f.y, f.z, zero, t.x, t.y, t.z, zero};
    for (std::size_t k = 0; k < numbers; k += lanes<Batch>()) {
      hn::Vec<Tag> rows[lanes<Batch>()];
      for (std::size_t i = 0; i < lanes<Batch>(); ++i) rows[i] = columns[k + i].v;
      transpose(rows);
      for (std::size_t i = 0; i < lanes<Batch>(); ++i) hn::Store(rows[i], Tag(), rows_[i].numbers.data() + k);
    }
  }

  HWY_INLINE void add(std::size_t i, const Wrench& wrench) { sum(rows_[i], wrench); }
  HWY_INLINE void add_to(Wrench& wrench, std::size_t i) const { sum(wrench, rows_[i]); }

  HWY_INLINE WrenchColumns columns() const {
    Batch columns[numbers];
    for (std::size_t k = 0; k < numbers; k += lanes<Batch>()) {
      hn::Vec<Tag> rows[lanes<Batch>()];
      for (std::size_t i = 0; i < lanes<Batch>(); ++i) rows[i] = hn::Load(Tag(), rows_[i].numbers.data() + k);
      transpose(rows);
      for (std::size_t i = 0; i < lanes<Batch>(); ++i) columns[k + i].v = rows[i];
    }
    return {{columns[0], columns[1], columns[2]}, {columns[4], columns[5], columns[6]}};
  }

 private:
  static constexpr std::size_t numbers = std::tuple_size_v<decltype(Wrench::numbers)>;

  static HWY_INLINE void sum(Wrench& to, const Wrench& from) {
    for (std::size_t k = 0; k < numbers; k += lanes<Batch>()) {
      double* at = to.numbers.data() + k;
      hn::Store(hn::Add(hn::Load(Tag(), at), hn::Load(Tag(), from.numbers.data() + k)), Tag(), at);
    }
  }

  Wrench rows_[lanes<Batch>()];
};

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
