#pragma once
// Superquadrics, with ellipsoids and spheres as their exact special cases.
//   (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1,   n1 = 2/η1, n2 = 2/η2
// The solid is the unit ball of a nested p-norm: gauge and support function are closed forms.

#include "osculate/core/types.hpp"
#include "osculate/shapes/surface.hpp"

namespace osculate {

/// Exponents of a superquadric: n1 joins z to the x–y norm, n2 joins x to y. Both in (1, 64].
struct Exponents {
  double n1 = 2.0;
  double n2 = 2.0;

  /// The review's form n = 2/η, η in [1/32, 2).
  static Exponents from_eta(double eta1, double eta2) { return {2.0 / eta1, 2.0 / eta2}; }
};

struct Superquadric {
  Vec3 half_axes;  ///< a, b, c > 0 [m]
  Exponents exponents;
};

struct Ellipsoid {
  Vec3 half_axes;  ///< a, b, c > 0 [m]
};

struct Sphere {
  double radius;  ///< > 0 [m]
};

inline Superquadric as_superquadric(const Superquadric& shape) {
  return shape;
}
inline Superquadric as_superquadric(const Ellipsoid& shape) {
  return {shape.half_axes, {2.0, 2.0}};
}
inline Superquadric as_superquadric(const Sphere& shape) {
  return {Vec3::Constant(shape.radius), {2.0, 2.0}};
}

/// Throws InputError unless the axes are positive and finite and the exponents lie in (1, 64].
void validate(const Superquadric& shape);
void validate(const Ellipsoid& shape);
void validate(const Sphere& shape);

/// N(x), its gradient and Hessian, body frame [m]; at x = 0 all are zero. On a rim of n < 2 (x, y or z exactly zero)
/// the curvature is infinite: 1e100 relative to the half-axes stands for it.                          [KDY23 (15)]
Gauge gauge(const Superquadric& shape, const Vec3& x);

/// h(u), ∇h and ∇∇h, body frame; at u = 0 all are zero. Where a face is flat (n > 2 and a component of u exactly zero)
/// the radius is infinite: 1e100 relative to the half-axes stands for it.
Support support(const Superquadric& shape, const Vec3& u);

/// A symmetric matrix a aᵀ + b bᵀ. Its small eigenvalue keeps its digits beside a large one.
struct RankTwoFactors {
  Vec3 a, b;
};

/// The gauge's Hessian at the surface point on the ray through x ≠ 0 [1/m²].
RankTwoFactors gauge_hessian_factors(const Superquadric& shape, const Vec3& x);

/// The surface point with outward normal u [m], on symmetry planes exactly. At u = 0 it is zero.
Vec3 support_point(const Superquadric& shape, const Vec3& u);

/// Radius of the smallest sphere about the centre that holds the body [m]; closed form, rounded up.
double bounding_radius(const Superquadric& shape);

OrientedBox oriented_box(const Superquadric& shape);

/// Closed form by Beta functions.                                                [JLS00]
MassProperties mass_properties(const Superquadric& shape);

}  // namespace osculate
