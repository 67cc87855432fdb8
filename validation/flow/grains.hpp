#pragma once
// What the grains of hopper and heap are made of, softer than real ones for a longer time step.

#include "osculate/dynamics/setup.hpp"

namespace osculate::validation {

inline constexpr ElasticMaterial soft{.youngs_modulus = 1e6, .poissons_ratio = 0.3};
inline constexpr double grain_density = 1300.0;  // kg/m³

/// Hertz with a dashpot of restitution 0.4, and friction by Mindlin's springs.
ContactLaw grain_law(double friction);

/// A 25th of the shortest impact at 1 m/s [s].
double flow_time_step(const Setup& setup);

/// A fixed plane, solid behind it; the setup has one fixed motion and one half-space at these places.
BodyStart fixed_plane(const Vec3& point, const Vec3& normal, std::int32_t half_space, std::int32_t material);

}  // namespace osculate::validation
