#pragma once
// Vectors, rotations and poses. Right-handed frames, SI units.
// A suffix names the frame where two meet: `_w` world, `_b` body.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace osculate {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
/// Eigen's own quaternion of doubles is aligned as the compiler's flags allow: code compiled for AVX and a library that
/// is not could not share one.
using Quat = Eigen::Quaternion<double, Eigen::DontAlign>;

/// Where a body is: x_w = orientation · x_b + position.
struct Pose {
  Vec3 position = Vec3::Zero();         ///< [m], world frame
  Quat orientation = Quat::Identity();  ///< unit quaternion, body → world

  Vec3 to_world(const Vec3& point_b) const { return orientation * point_b + position; }
  Vec3 to_body(const Vec3& point_w) const { return orientation.conjugate() * (point_w - position); }
  Vec3 rotate_to_world(const Vec3& direction_b) const { return orientation * direction_b; }
  Vec3 rotate_to_body(const Vec3& direction_w) const { return orientation.conjugate() * direction_w; }
};

}  // namespace osculate
