#pragma once
// Superquadrics, with ellipsoids and spheres as their exact special cases.       [KDY23 (15)]
//   (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1,   n1 = 2/η1, n2 = 2/η2
// The solid is the unit ball of a nested p-norm: gauge and support function are closed forms.

#include "osculate/core/types.hpp"
#include "osculate/shapes/surface.hpp"

namespace osculate {

/// Exponents of a superquadric: n1 joins z to the x–y norm, n2 joins x to y. Both in (1, 64].
struct Exponents {
  double n1 = 2.0;
  double n2 = 2.0;

  /// The review's form n = 2/η, η in [1/32, 2).                                 [KDY23 (15)]
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

/// N(x), its gradient and Hessian; x ≠ 0, body frame [m].
Gauge gauge(const Superquadric& shape, const Vec3& x);

/// h(u), ∇h and ∇∇h; u ≠ 0, body frame. Where a face is flat (n > 2) radii reach 1e100 m instead of ∞.
Support support(const Superquadric& shape, const Vec3& u);

/// The surface point with outward normal u [m].
Vec3 support_point(const Superquadric& shape, const Vec3& u);

/// Radius of the smallest sphere about the centre that holds the body [m].
double bounding_radius(const Superquadric& shape);

OrientedBox oriented_box(const Superquadric& shape);

/// Closed form by Beta functions (Jaklič, Leonardis & Solina 2000).
MassProperties mass_properties(const Superquadric& shape);

}  // namespace osculate
