#pragma once
// Fixed boundaries with a frame of their own. A particle touches them from the side the normal points to.

#include "osculate/core/types.hpp"

namespace osculate {

/// Solid z ≤ 0 of its frame; outward normal +z.
struct HalfSpace {};

/// Infinite circular cylinder about z of its frame.
struct Cylinder {
  double radius;  ///< > 0 [m]
  enum class Solid {
    inside,
    outside
  } solid;  ///< `inside`: a rod, particles outside; `outside`: a drum, particles inside
};

/// The solid outside a sphere: a spherical container with particles inside.
struct SphereContainer {
  double radius;  ///< > 0 [m]
};

/// Throws InputError unless the radius is positive and finite.
void validate(const HalfSpace& wall);
void validate(const Cylinder& wall);
void validate(const SphereContainer& wall);

/// Where a point lies with respect to a wall.
struct WallDistance {
  double value;  ///< [m], positive outside the solid
  Vec3 normal;   ///< the wall's outward unit normal at its nearest point; +x where every direction is as near
};

/// Distance to the wall's surface; x in the wall's frame [m]. x − value · normal is the nearest surface point.
WallDistance signed_distance(const HalfSpace& wall, const Vec3& x);
WallDistance signed_distance(const Cylinder& wall, const Vec3& x);
WallDistance signed_distance(const SphereContainer& wall, const Vec3& x);

}  // namespace osculate
