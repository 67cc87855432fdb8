// Sine and cosine of the turn of a time step.
#if defined(OSCULATE_MECHANICS_TURN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef OSCULATE_MECHANICS_TURN_INL
#undef OSCULATE_MECHANICS_TURN_INL
#else
#define OSCULATE_MECHANICS_TURN_INL
#endif

#include "core/batch-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace osculate {
namespace HWY_NAMESPACE {

struct Turn {
  Batch sine, cosine;
};

/// Turns of a step are small: up to 0.05 rad Taylor's polynomials leave 1e-17.
HWY_INLINE Turn turn_of(const Batch& angle) {
  static constexpr double small = 0.05;
  if (any(abs(angle) > Batch(small))) return {sin(angle), cos(angle)};
  const Batch square_angle = angle * angle, one(1.0);
  const auto next = [&](const Batch& rest, double factor)
                        HWY_ATTR { return one - square_angle * Batch(factor) * rest; };
  return {angle * next(next(next(one, 1.0 / 42.0), 1.0 / 20.0), 1.0 / 6.0),
          next(next(next(next(one, 1.0 / 56.0), 1.0 / 30.0), 1.0 / 12.0), 0.5)};
}

}  // namespace HWY_NAMESPACE
}  // namespace osculate
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
