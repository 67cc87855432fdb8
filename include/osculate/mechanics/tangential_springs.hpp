#pragma once
// Friction of spheres, the simple models: sliding, viscous, and linear springs with dashpots and a slider. [Wassgren06]
// Forces act on body 1, which moves with the relative velocity or displacement given (body 1 less body 2). F_n ≥ 0.

#include "osculate/mechanics/tangent_vector.hpp"

namespace osculate::tangential_springs {

/// Sliding: F = −μ F_n v/|v|, zero at rest. It jumps where the velocity turns; resting contacts chatter.
TangentVector sliding(double friction, double normal_force, const TangentVector& velocity);

/// Viscous: F = −c v, without limit.
TangentVector viscous(double damping, const TangentVector& velocity);

/// Viscous and sliding: F = −min(c |v|, μ F_n) v/|v|. Creeps under any steady load.
TangentVector viscous_sliding(double damping, double friction, double normal_force, const TangentVector& velocity);

/// Spring, dashpot and slider; c = 0 is the spring and slider.                                                   [CS79]
struct Model {
  double stiffness;      ///< k_t > 0 [N/m]
  double damping = 0.0;  ///< c_t ≥ 0 [N s/m]
  double friction;       ///< μ ≥ 0
};

/// Throws InputError unless k_t > 0, c_t ≥ 0, μ ≥ 0, all finite.
void validate(const Model& model);

/// Starts at zero when two bodies meet.
struct Memory {
  TangentVector stretch;  ///< of the spring [m]
};

/// The step's force: the spring stretched by `displacement`, plus the dashpot; |F| ≤ μ F_n always. In sliding the
/// spring gives way until spring and dashpot together hold the limit. Brings `memory` up to date.
/// @param displacement  relative tangential displacement of body 1 during the step [m]
TangentVector force(const Model& model, double normal_force, const TangentVector& displacement,
                    const TangentVector& velocity, Memory& memory);

/// k_t/k_n of a Hertz–Mindlin contact without slip: 8 Ĝ a/(2 Ê a) = 4 Ĝ/Ê; 2 (1 − ν)/(2 − ν) for like materials.
/// @param shear_modulus  Ĝ, see effective_shear_modulus
double stiffness_ratio(double modulus, double shear_modulus);

/// c_t of tangential restitution ε_t of two like solid spheres, whose tangential effective mass is 2/7 m:
///   c_t = 2 ζ (2 m k_t/7)^{1/2}, ζ = −ln ε_t/(π² + ln² ε_t)^{1/2} [DVHK07]
/// @param mass  m, the normal effective mass > 0 [kg];  restitution ε_t in (0, 1]. Throws InputError otherwise.
double damping_for_restitution(double stiffness, double mass, double restitution);

}  // namespace osculate::tangential_springs
