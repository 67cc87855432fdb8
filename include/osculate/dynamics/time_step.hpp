#pragma once
// How long a time step may be.

#include <string>

#include "osculate/dynamics/setup.hpp"

namespace osculate {

/// What limits the time step of a setup.
struct TimeStepLimits {
  double contact_duration;  ///< of the shortest impact at the given speed [s]
  double rayleigh_time;     ///< of a surface wave around half of the smallest particle [s]
  std::string shortest;     ///< which pair has the shortest impact: "shape 1, glass on shape 3, steel"
  double recommended;  ///< contact_duration / steps_per_contact or rayleigh_share · rayleigh_time, the smaller [s]
  double largest;      ///< a step above this is unsafe: contact_duration / fewest_steps_per_contact [s]
};

inline constexpr double steps_per_contact = 40.0;
inline constexpr double fewest_steps_per_contact = 10.0;
inline constexpr double rayleigh_share = 0.2;

/// Impacts are computed with the interaction laws themselves, for every two kinds of bodies that may meet, at their
/// stiffest: the flattest places of both surfaces on each other (radii up to the setup's cap) and the least effective
/// mass of each body, 1/m' = 1/m + max |x × n|²/I over its surface. An impact takes twice the time to the deepest
/// overlap.
/// Rayleigh: t_R = π r (ρ/G)^{1/2}/(0.1631 ν + 0.8766), r the least half width.                   [TR88]
/// @param speed  the fastest impact to be expected > 0 [m/s]
/// Setup::time_step is not looked at. Throws InputError as validate(setup) does otherwise, and unless speed > 0.
TimeStepLimits time_step_limits(const Setup& setup, double speed);

}  // namespace osculate
