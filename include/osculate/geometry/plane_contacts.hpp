#pragma once
// Superquadrics against half-spaces in bulk: in closed form, so that nothing is kept between two calls.

#include "osculate/geometry/superquadric_contacts.hpp"

namespace osculate {

/// What stands for the half-space in a pair.
inline const Superquadric half_space_numbers{.half_axes = Vec3::Zero(), .exponents = {0.0, 0.0}};

/// The contact of every pair of a superquadric and a half-space (solid z ≤ 0 of its frame), in either order: the one
/// without half-axes is the half-space. `contacts` is resized to fit. A gap has points and curvatures too. What
/// is not finite is degenerate, with zeros. Each pair's answer is bit-identical whatever pairs stand beside it, and
/// exchanged bodies exchange it. Any other pair is degenerate too.
void plane_contacts(const SuperquadricPairs& pairs, ContactColumns& contacts);

}  // namespace osculate
