#pragma once
// One impact of a sphere on a sphere or a plane, simulated by the engine from just before touch to just after parting.

#include <optional>

#include "osculate/dynamics/setup.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace osculate::validation {

struct Ball {
  double radius;  ///< [m]
  Material material;
  Vec3 velocity = Vec3::Zero();          ///< [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
};

/// Ball 1 stands left of x = 0. There it meets ball 2 or, without one, a plane that looks to −x.
struct Collision {
  Ball ball_1;
  std::optional<Ball> ball_2;
  Material plane = {};
  LawChoice law;
  int steps = 1000;  ///< of the elastic impact
};

struct Outcome {
  Vec3 velocity_1, angular_velocity_1;  ///< afterwards
  Vec3 velocity_2 = Vec3::Zero(), angular_velocity_2 = Vec3::Zero();
  double duration;         ///< within a step [s]
  double largest_overlap;  ///< [m]
  double largest_force;    ///< along x [N]
  double time_step;        ///< [s]
};

/// Mass and effective constants of the two, for closed forms.
struct CollisionPair {
  double mass_1, mass_2;  ///< [kg]; ∞ for the plane
  double reduced_mass;    ///< [kg]
  double radius;          ///< effective [m]
  double modulus;         ///< effective [Pa]
  double speed;           ///< with which they approach [m/s]
};
CollisionPair pair_of(const Collision& collision);

/// Throws InputError unless the two approach each other; std::runtime_error if they do not part.
Outcome collide(const Collision& collision);

}  // namespace osculate::validation
