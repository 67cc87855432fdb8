// A square of batches, turned about its diagonal.
#if defined(OSCULATE_CORE_TRANSPOSE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_CORE_TRANSPOSE_INL
#undef OSCULATE_CORE_TRANSPOSE_INL
#else
#define OSCULATE_CORE_TRANSPOSE_INL
#endif

#include "core/batch-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

static_assert(lanes<Batch>() <= 8);

/// Rows become columns: rows[i] lane k goes to rows[k] lane i.
HWY_INLINE void transpose([[maybe_unused]] hn::Vec<Tag> (&rows)[lanes<Batch>()]) {
#if HWY_TARGET != HWY_SCALAR
  const Tag d;
  hn::Vec<Tag> pairs[lanes<Batch>()];  // pairs[k + 2 p]: what rows 2 p and 2 p + 1 hold in even (k = 0) or odd columns
  for (std::size_t i = 0; i < lanes<Batch>(); i += 2) {
    pairs[i] = hn::InterleaveLower(d, rows[i], rows[i + 1]);
    pairs[i + 1] = hn::InterleaveUpper(d, rows[i], rows[i + 1]);
  }
#if HWY_TARGET <= HWY_AVX3
  for (std::size_t k = 0; k < 2; ++k) {
    const auto a = pairs[k], b = pairs[k + 2], c = pairs[k + 4], e = pairs[k + 6];
    const auto ab_even = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a);
    const auto ab_odd = hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a));
    const auto ce_even = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(e), c);
    const auto ce_odd = hn::OddEvenBlocks(e, hn::SwapAdjacentBlocks(c));
    rows[k] = hn::ConcatLowerLower(d, ce_even, ab_even);
    rows[k + 2] = hn::ConcatLowerLower(d, ce_odd, ab_odd);
    rows[k + 4] = hn::ConcatUpperUpper(d, ce_even, ab_even);
    rows[k + 6] = hn::ConcatUpperUpper(d, ce_odd, ab_odd);
  }
#elif HWY_TARGET <= HWY_AVX2
  for (std::size_t k = 0; k < 2; ++k) {
    rows[k] = hn::ConcatLowerLower(d, pairs[k + 2], pairs[k]);
    rows[k + 2] = hn::ConcatUpperUpper(d, pairs[k + 2], pairs[k]);
  }
#else
  for (std::size_t k = 0; k < 2; ++k) rows[k] = pairs[k];
#endif
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
