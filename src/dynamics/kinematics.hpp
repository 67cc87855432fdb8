#pragma once
// The bodies as the pairs want them: what a pair needs of a body stands together.

#include <array>
#include <vector>

#include "osculate/core/types.hpp"

namespace osculate {

/// A body at the end of a step, before its second half kick.
struct alignas(64) BodyRecord {
  /// Half-axes and exponents (superquadrics only), position, orientation w, x, y, z: the columns of SuperquadricPairs.
  std::array<double, 12> placed{};
  Vec3 velocity = Vec3::Zero();               ///< of the middle of the step [m/s]
  Vec3 mean_angular_velocity = Vec3::Zero();  ///< of the step [rad/s], world
  /// Extrapolated to the end of the step with the forces of its beginning.
  Vec3 last_velocity = Vec3::Zero();
  Vec3 last_angular_velocity = Vec3::Zero();

  Vec3 position() const { return {placed[5], placed[6], placed[7]}; }
  Quat orientation() const { return {placed[8], placed[9], placed[10], placed[11]}; }
  Pose pose() const { return {position(), orientation()}; }
  void place(const Vec3& x, const Quat& q) {
    placed[5] = x.x(), placed[6] = x.y(), placed[7] = x.z();
    placed[8] = q.w(), placed[9] = q.x(), placed[10] = q.y(), placed[11] = q.z();
  }
};

struct Kinematics {
  std::vector<BodyRecord> records;
  /// A bound of the way of any point of the body since the list of pairs was made [m].
  std::vector<double> travel;
  /// How far each body may go before the pairs are listed anew [m].
  std::vector<double> skin;
  double time_step = 0.0;  ///< [s]; 0 when forces are evaluated for the first time
};

}  // namespace osculate
