#pragma once
// The tangent plane of a unit normal, and symmetric 2×2 matrices in it.

#include <cmath>

#include "osculate/core/types.hpp"

namespace osculate {

/// Two orthonormal tangents: the first as near as can be to the coordinate axis furthest from the normal (the first
/// such axis), the same for n and −n.
struct TangentPlane {
  Vec3 first, second;

  explicit TangentPlane(const Vec3& normal) {
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
      if (std::fabs(normal[i]) < std::fabs(normal[axis])) axis = i;
    }
    first = (Vec3::Unit(axis) - normal[axis] * normal).normalized();
    second = normal.cross(first);
  }

  Vec3 lift(double angle) const { return std::cos(angle) * first + std::sin(angle) * second; }
  Eigen::Vector2d coordinates(const Vec3& v) const { return {first.dot(v), second.dot(v)}; }
};

/// Angle of the eigenvector of the larger eigenvalue of [[xx, xy], [xy, yy]]; 0 where every vector is one.
inline double major_angle(double xx, double xy, double yy) {
  return 0.5 * std::atan2(2.0 * xy, xx - yy);
}

}  // namespace osculate
