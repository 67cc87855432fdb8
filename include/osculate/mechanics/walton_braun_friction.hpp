#pragma once
// Incrementally slipping friction: a tangential stiffness that falls to zero as slip spreads over the contact, and
// starts anew at every turn.                                                                          [WB86; Walton93]

#include "osculate/mechanics/tangent_vector.hpp"

namespace osculate::walton_braun_friction {

struct Model {
  double stiffness;             ///< K_0 > 0 [N/m], without slip
  double friction;              ///< μ ≥ 0
  double exponent = 1.0 / 3.0;  ///< γ in (0, 1); 1/3 is Mindlin's
};

/// Throws InputError unless K_0 > 0, μ ≥ 0, 0 < γ < 1, all finite.
void validate(const Model& model);

/// Starts at zero when two bodies meet. The signed force T and the turning force T* lie along `direction`.
struct Memory {
  TangentVector direction;    ///< unit, or zero before the first motion
  double force = 0.0;         ///< T [N], positive against a displacement of body 1 along `direction`
  double turning = 0.0;       ///< T* [N]: T where the motion last turned; 0 before any turn
  double normal_force = 0.0;  ///< F_n of the last step [N]
  bool backward = false;      ///< the motion runs against `direction`
};

/// The force on body 1, −T along the direction, after a step:
///   dT/ds = K_0 [1 − (T − T*)/(μ F_n − T*)]^γ   while moving along the direction
///   dT/ds = K_0 [1 − (T* − T)/(μ F_n + T*)]^γ   while moving back,
/// integrated exactly over the step; square to the direction the stiffness is K_0, and the direction follows the force.
/// T* scales with F_n. |F| ≤ μ F_n always; F_n = 0 clears the memory, which is brought up to date.
/// @param displacement  of body 1 relative to body 2 during the step [m]
TangentVector force(const Model& model, double normal_force, const TangentVector& displacement, Memory& memory);

/// What a motion that takes the force back to zero would give back [J]: along the path the contact is on if it is being
/// unloaded, else along the one that starts here.
double recoverable_energy(const Model& model, const Memory& memory);

}  // namespace osculate::walton_braun_friction
