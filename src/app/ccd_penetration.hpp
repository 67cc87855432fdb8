#pragma once
// Penetration of two superquadrics by libccd's GJK and EPA on the same support functions: the plain scalar contact that
// most codes have, for comparison.

#include <optional>

#include "osculate/core/types.hpp"
#include "osculate/shapes/superquadric.hpp"

namespace osculate::app {

struct PlacedBody {
  Superquadric shape;
  Vec3 position;       ///< [m]
  Mat3 body_to_world;  ///< rotation
};

PlacedBody place(const Superquadric& shape, const Pose& pose);

/// Depth [m] by ccdGJKPenetration; nothing when it finds the bodies apart or gives up.
/// `tolerance` stops EPA; libccd holds it against squared lengths [m²], its own default is 1e-4.
std::optional<double> ccd_penetration(const PlacedBody& body_1, const PlacedBody& body_2, double tolerance);

}  // namespace osculate::app
