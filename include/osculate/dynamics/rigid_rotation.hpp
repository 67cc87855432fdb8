#pragma once
// The rotation of a free rigid body, by a splitting that is time-reversible, of second order and keeps |L| to
// round-off.

#include "osculate/core/types.hpp"

namespace osculate {

/// Orientation and angular momentum of a rigid body.
struct Spin {
  Quat orientation;  ///< body → world
  Vec3 momentum;     ///< L [kg m²/s], body frame
};

/// What a step of free rotation did.
struct Turn {
  Spin spin;
  Vec3 mean_velocity;  ///< the angular velocity that, kept for the step, turns as much about the same axis [rad/s],
                       ///< world
};

/// One step of free rotation: rotations about the principal axes, x/2 y/2 z y/2 x/2. Each is the flow of a function of
/// its own component of L: the step is a Poisson map, symmetric, and keeps |L|.              [DLM97 §III]
/// The angle of each is 2 atan(θ/2) in place of θ = dt L_k/I_k: no trigonometry, still a flow, still second order.
/// @param inertia  principal moments > 0 [kg m²]
/// Valid while dt |L_k|/I_k is well below 1; beyond, the rotation lags behind.
Turn rotate_free(const Spin& spin, const Vec3& inertia, double dt);

}  // namespace osculate
