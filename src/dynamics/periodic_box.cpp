#include "osculate/dynamics/periodic_box.hpp"

#include <cmath>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate {

void validate(const PeriodicBox& box) {
  if (!box.origin.allFinite()) throw InputError("periodic box", "an origin that is not finite", "a point");
  for (Eigen::Index k = 0; k < 3; ++k)
    if (!(box.length[k] > 0.0))
      throw InputError("periodic box", "a length of " + std::to_string(box.length[k]) + " m", "a positive length");
}

Vec3 nearest_image_shift(const PeriodicBox& box, const Vec3& difference) {
  Vec3 shift = Vec3::Zero();
  for (Eigen::Index k = 0; k < 3; ++k)
    if (std::isfinite(box.length[k])) shift[k] = -box.length[k] * std::nearbyint(difference[k] / box.length[k]);
  return shift;
}

Vec3 wrapped(const PeriodicBox& box, const Vec3& position) {
  Vec3 inside = position;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double length = box.length[k];
    if (!std::isfinite(length)) continue;
    inside[k] -= length * std::floor((position[k] - box.origin[k]) / length);
    if (inside[k] >= box.origin[k] + length) inside[k] = box.origin[k];  // a tiny negative rounds up to the length
  }
  return inside;
}

}  // namespace osculate
