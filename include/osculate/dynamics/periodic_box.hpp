#pragma once
// Space that repeats along some of the world's axes.

#include <limits>
#include <optional>
#include <vector>

#include "osculate/core/types.hpp"

namespace osculate {

/// The images of a box across one axis move along another: space is sheared, and no wall is needed.     [LE72]
struct BoxShear {
  Eigen::Index flow;      ///< the axis along which images move
  Eigen::Index gradient;  ///< the axis across which they are
  double rate;            ///< mean velocity along the flow per length along the gradient [1/s]
  double offset = 0.0;    ///< of the image above along the flow [m]
};

/// The box [origin, origin + length); an infinite length is an axis that does not repeat.
struct PeriodicBox {
  Vec3 origin = Vec3::Zero();                                             ///< [m]
  Vec3 length = Vec3::Constant(std::numeric_limits<double>::infinity());  ///< > 0 [m]

  std::optional<BoxShear> shear = std::nullopt;  ///< both its axes repeat

  bool repeats() const { return (length.array() < std::numeric_limits<double>::infinity()).any(); }
};

/// Throws InputError unless the lengths are positive, the origin is finite and a shear has two axes that repeat.
void validate(const PeriodicBox& box);

/// The box as it is at time t that is `box` at time 0.
PeriodicBox at_time(const PeriodicBox& box, double t);

/// The way from a point to that of its images which brings a difference of positions nearest to zero, when added [m].
Vec3 nearest_image_shift(const PeriodicBox& box, const Vec3& difference);

/// The way to the image inside the box, and the image [m].
Vec3 shift_inside(const PeriodicBox& box, const Vec3& position);
Vec3 wrapped(const PeriodicBox& box, const Vec3& position);

/// How fast an image that is `shift` away moves against the original [m/s].
Vec3 image_velocity(const PeriodicBox& box, const Vec3& shift);

/// A point of the box and its images up to one box away.
std::vector<Vec3> near_images(const PeriodicBox& box, const Vec3& inside);

}  // namespace osculate
