#include "osculate/dynamics/periodic_box.hpp"

#include <cmath>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate {
namespace {

/// Steps of one box along an axis; across the gradient of a shear they lead along the flow, too.
Vec3 box_steps(const PeriodicBox& box, Eigen::Index axis, double count) {
  Vec3 shift = Vec3::Zero();
  shift[axis] = count * box.length[axis];
  if (box.shear && axis == box.shear->gradient) shift[box.shear->flow] = count * box.shear->offset;
  return shift;
}

/// Axes that repeat, in the order in which to step: that of a shear's flow after that of its gradient.
template <class Step>
void for_axes(const PeriodicBox& box, const Step& step) {
  const auto late = [&](Eigen::Index k) { return box.shear && k == box.shear->flow; };
  for (Eigen::Index k = 0; k < 3; ++k)
    if (std::isfinite(box.length[k]) && !late(k)) step(k);
  if (box.shear) step(box.shear->flow);
}

}  // namespace

void validate(const PeriodicBox& box) {
  if (!box.origin.allFinite()) throw InputError("periodic box", "an origin that is not finite", "a point");
  for (Eigen::Index k = 0; k < 3; ++k)
    if (!(box.length[k] > 0.0))
      throw InputError("periodic box", "a length of " + std::to_string(box.length[k]) + " m", "a positive length");
  if (!box.shear) return;
  const BoxShear& shear = *box.shear;
  const auto repeats = [&](Eigen::Index k) { return k >= 0 && k < 3 && std::isfinite(box.length[k]); };
  if (shear.flow == shear.gradient || !repeats(shear.flow) || !repeats(shear.gradient))
    throw InputError(
        "periodic box",
        "a shear along axis " + std::to_string(shear.flow) + " across axis " + std::to_string(shear.gradient),
        "two different axes that repeat");
  if (!std::isfinite(shear.rate) || !std::isfinite(shear.offset))
    throw InputError("periodic box", "a shear of " + std::to_string(shear.rate) + " 1/s", "finite numbers");
}

PeriodicBox at_time(const PeriodicBox& box, double t) {
  PeriodicBox now = box;
  if (box.shear) {
    const double length = box.length[box.shear->flow];
    const double way = box.shear->offset + box.shear->rate * box.length[box.shear->gradient] * t;
    now.shear->offset = std::remainder(way, length);
  }
  return now;
}

Vec3 nearest_image_shift(const PeriodicBox& box, const Vec3& difference) {
  Vec3 shift = Vec3::Zero();
  for_axes(box, [&](Eigen::Index k) {
    shift += box_steps(box, k, -std::nearbyint((difference[k] + shift[k]) / box.length[k]));
  });
  return shift;
}

Vec3 shift_inside(const PeriodicBox& box, const Vec3& position) {
  Vec3 shift = Vec3::Zero();
  for_axes(box, [&](Eigen::Index k) {
    shift += box_steps(box, k, -std::floor((position[k] + shift[k] - box.origin[k]) / box.length[k]));
  });
  return shift;
}

Vec3 wrapped(const PeriodicBox& box, const Vec3& position) {
  Vec3 inside = position + shift_inside(box, position);
  for (Eigen::Index k = 0; k < 3; ++k)  // a tiny negative rounds up to the length
    if (inside[k] >= box.origin[k] + box.length[k]) inside[k] = box.origin[k];
  return inside;
}

Vec3 image_velocity(const PeriodicBox& box, const Vec3& shift) {
  if (!box.shear) return Vec3::Zero();
  return box.shear->rate * shift[box.shear->gradient] * Vec3::Unit(box.shear->flow);
}

std::vector<Vec3> near_images(const PeriodicBox& box, const Vec3& inside) {
  std::vector<Vec3> images{inside};
  for_axes(box, [&](Eigen::Index k) {
    const std::size_t count = images.size();
    for (std::size_t i = 0; i < count; ++i)
      for (const double side : {-1.0, 1.0}) images.push_back(images[i] + box_steps(box, k, side));
  });
  return images;
}

}  // namespace osculate
