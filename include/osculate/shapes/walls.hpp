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

}  // namespace osculate
