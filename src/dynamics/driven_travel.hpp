#pragma once
// How far the surface of a driven body moves where particles are.

#include "osculate/dynamics/body_shape.hpp"

namespace osculate {

/// What a driven body did in a step.
struct DrivenStep {
  Vec3 displacement;  ///< [m]
  Vec3 turn;          ///< [rad]
};

/// A ball that holds all particles.
struct ParticlesWithin {
  Vec3 centre;    ///< [m]
  double radius;  ///< [m]
};

/// A bound of the way of the surface in a step where particles are [m]. A wall that slides or turns in itself does not
/// move.
/// @param pose  of the body at the end of the step
double driven_travel(const BodyShape& shape, const Pose& pose, const DrivenStep& step,
                     const ParticlesWithin& particles);

}  // namespace osculate
