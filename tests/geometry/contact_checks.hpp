#pragma once
// What the tests of the narrow phase share: poses, placed bodies, and a search for the common normal by brute force.

#include <algorithm>
#include <cmath>
#include <random>

#include "osculate/geometry/common_normal.hpp"
#include "shapes/sample_shapes.hpp"

namespace osculate::checks {

inline Quat random_orientation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
}

struct Body {
  Shape shape;
  Pose pose;
};

inline ContactGeometry contact_of(const Body& a, const Body& b) {
  return common_normal(a.shape, a.pose, b.shape, b.pose);
}

inline Vec3 support_w(const Body& body, const Vec3& direction_w) {
  return body.pose.to_world(support_point(body.shape, body.pose.rotate_to_body(direction_w)));
}

/// g(u) = h1(u) + h2(−u) − u·(c2 − c1)
inline double overlap_along(const Body& a, const Body& b, const Vec3& u) {
  return (support_w(a, u) - support_w(b, -u)).dot(u);
}

/// min g(u): random directions and a given one, then random steps that shrink where they no longer descend.
inline double brute_force_overlap(const Body& a, const Body& b, const Vec3& first, std::mt19937& random) {
  double least = overlap_along(a, b, first);
  Vec3 best = first;
  const auto attempt = [&](const Vec3& u) {
    const double overlap = overlap_along(a, b, u);
    if (!(overlap < least)) return false;
    least = overlap;
    best = u;
    return true;
  };
  for (int i = 0; i < 300; ++i) attempt(samples::random_direction(random));
  for (double step = 0.2; step > 1e-9;) {
    bool descended = false;
    for (int i = 0; i < 10; ++i)
      descended = attempt((best + step * samples::random_direction(random)).normalized()) || descended;
    if (!descended) step *= 0.6;
  }
  return least;
}

/// Moves b along the line of centres until the bodies overlap by about `overlap`.
inline void bring_together(const Body& a, Body& b, double overlap) {
  const Vec3 along = (b.pose.position - a.pose.position).normalized();
  for (int i = 0; i < 30; ++i) {
    const ContactGeometry contact = contact_of(a, b);
    const double excess = contact.overlap - overlap;
    if (std::fabs(excess) < 1e-3 * overlap) return;
    b.pose.position += (excess / std::max(0.2, contact.normal.dot(along))) * along;
  }
}

}  // namespace osculate::checks
