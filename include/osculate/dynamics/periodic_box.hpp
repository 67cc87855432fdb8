#pragma once
// Space that repeats along some of the world's axes.

#include <limits>

#include "osculate/core/types.hpp"

namespace osculate {

/// The box [origin, origin + length); an infinite length is an axis that does not repeat.
struct PeriodicBox {
  Vec3 origin = Vec3::Zero();                                             ///< [m]
  Vec3 length = Vec3::Constant(std::numeric_limits<double>::infinity());  ///< > 0 [m]

  bool repeats() const { return (length.array() < std::numeric_limits<double>::infinity()).any(); }
};

/// Throws InputError unless the lengths are positive and the origin finite.
void validate(const PeriodicBox& box);

/// The multiple of the box lengths that brings a difference of positions nearest to zero, when added [m].
Vec3 nearest_image_shift(const PeriodicBox& box, const Vec3& difference);

/// The same point inside the box.
Vec3 wrapped(const PeriodicBox& box, const Vec3& position);

}  // namespace osculate
