#pragma once
// Prescribed motions: bodies that move as they are told, whatever pushes them. Each is a function of time alone, so
// that nothing accumulates.

#include <variant>
#include <vector>

#include "osculate/core/types.hpp"

namespace osculate {

struct Fixed {};

/// Constant velocity between two times; at rest before and after.
struct Translation {
  Vec3 velocity;       ///< [m/s]
  double begin = 0.0;  ///< [s]
  double end;          ///< ≥ begin [s], may be ∞
};

/// Constant rotation about an axis through a point.
struct Rotation {
  Vec3 point;   ///< [m]
  Vec3 axis;    ///< unit vector; the rotation is right-handed about it
  double rate;  ///< [rad/s]
};

/// Displacement amplitude · (sin(2π f t + phase) − sin(phase)).
struct Oscillation {
  Vec3 amplitude;      ///< [m]
  double frequency;    ///< f ≥ 0 [Hz]
  double phase = 0.0;  ///< [rad]
};

/// Displacements at given times, straight lines between them, at rest before and after.
struct Path {
  std::vector<double> times;        ///< [s], increasing
  std::vector<Vec3> displacements;  ///< [m], one a time
};

using Motion = std::variant<Fixed, Translation, Rotation, Oscillation, Path>;

/// Throws InputError unless every number is finite and as said above.
void validate(const Motion& motion);

/// A body on its way.
struct Moving {
  Pose pose;
  Vec3 velocity;          ///< of the body's origin [m/s]
  Vec3 angular_velocity;  ///< [rad/s], world
};

/// Where a body is at time t that was at `start` at time 0.
Moving at_time(const Motion& motion, const Pose& start, double t);

}  // namespace osculate
