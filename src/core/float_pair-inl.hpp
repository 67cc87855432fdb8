// Two numbers as floats in the room of one double, for what need not be kept to full precision.
#if defined(OSCULATE_CORE_FLOAT_PAIR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_CORE_FLOAT_PAIR_INL
#undef OSCULATE_CORE_FLOAT_PAIR_INL
#else
#define OSCULATE_CORE_FLOAT_PAIR_INL
#endif

#include <cstdint>
#include <cstring>

#include "core/batch-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

/// Beyond the range of floats the result is not defined.
HWY_INLINE double pack_floats(double a, double b) {
  const float pair[2] = {static_cast<float>(a), static_cast<float>(b)};
  double both;
  std::memcpy(&both, pair, sizeof both);
  return both;
}
HWY_INLINE void unpack_floats(double both, double& a, double& b) {
  float pair[2];
  std::memcpy(pair, &both, sizeof both);
  a = static_cast<double>(pair[0]);
  b = static_cast<double>(pair[1]);
}
HWY_INLINE Batch pack_floats(Batch a, Batch b) {
  const hn::RebindToUnsigned<Tag> wide;
  const hn::Rebind<std::uint32_t, Tag> narrow;
  const hn::Rebind<float, Tag> single;
  const auto low = hn::PromoteTo(wide, hn::BitCast(narrow, hn::DemoteTo(single, a.v)));
  const auto high = hn::PromoteTo(wide, hn::BitCast(narrow, hn::DemoteTo(single, b.v)));
  return Batch(hn::BitCast(Tag(), hn::Or(low, hn::ShiftLeft<32>(high))));
}
HWY_INLINE void unpack_floats(Batch both, Batch& a, Batch& b) {
  const hn::RebindToUnsigned<Tag> wide;
  const hn::Rebind<std::uint32_t, Tag> narrow;
  const hn::Rebind<float, Tag> single;
  const auto words = hn::BitCast(wide, both.v);
  a = Batch(hn::PromoteTo(Tag(), hn::BitCast(single, hn::TruncateTo(narrow, words))));
  b = Batch(hn::PromoteTo(Tag(), hn::BitCast(single, hn::TruncateTo(narrow, hn::ShiftRight<32>(words)))));
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
