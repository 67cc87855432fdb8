#pragma once
// What every convex shape answers about its surface, in its own body frame.

#include "osculate/core/types.hpp"

namespace osculate {

/// The gauge N of a convex body with the origin inside: N(t x) = t N(x), N = 1 on the surface.
/// ∇N/|∇N| is the outward normal; the tangent-plane part of hessian/|∇N| is the shape operator [1/m].
struct Gauge {
  double value;   ///< N(x) [-]
  Vec3 gradient;  ///< ∇N [1/m]
  Mat3 hessian;   ///< ∇∇N [1/m²]
};

/// The support function h(u) = max over the body of u·x, homogeneous of degree 1 in u.
/// ∇h is the surface point with outward normal u; the tangent-plane part of ∇∇h at |u| = 1 has the
/// principal radii of curvature as eigenvalues [m].
struct Support {
  double value;  ///< h(u) [m] for unit u
  Vec3 point;    ///< ∇h(u) [m]
  Mat3 hessian;  ///< ∇∇h(u) [m]
};

/// Volume, centroid and inertia about the centroid, for unit density.
struct MassProperties {
  double volume;          ///< [m³]
  Vec3 centroid;          ///< [m], body frame
  Mat3 inertia;           ///< ∫ (|r|² I − r rᵀ) dV about the centroid [m⁵]
  double relative_error;  ///< estimated; 0 where the values are closed forms to round-off
};

/// A box around the body, aligned with the body frame.
struct OrientedBox {
  Vec3 centre;        ///< [m], body frame
  Vec3 half_extents;  ///< [m]
};

/// Radius of the sphere of equal volume [m].
double volume_equivalent_radius(double volume);

}  // namespace osculate
