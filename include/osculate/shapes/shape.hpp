#pragma once
// The closed set of shapes, and the questions every one of them answers.

#include <string_view>
#include <variant>

#include "osculate/shapes/potential_particle.hpp"
#include "osculate/shapes/superquadric.hpp"
#include "osculate/shapes/walls.hpp"

namespace osculate {

using Shape = std::variant<Superquadric, Ellipsoid, Sphere, PotentialParticle, HalfSpace, Cylinder, SphereContainer>;

/// "superquadric", "ellipsoid", "sphere", "potential particle", "half-space", "cylinder", "sphere container".
std::string_view kind(const Shape& shape);

/// True for bodies of finite volume; false for walls.
bool is_particle(const Shape& shape);

/// Throws InputError with what is wrong.
void validate(const Shape& shape);

/// The gauge of a particle: value, gradient and Hessian at x ≠ 0, body frame; x / value is the surface point on the ray
/// through x. Throws InputError for walls.
Gauge gauge(const Shape& shape, const Vec3& x_b);

/// The surface point of a particle with outward normal u ≠ 0, body frame [m]. Throws InputError for walls.
Vec3 support_point(const Shape& shape, const Vec3& u_b);

/// Radius of a sphere about the body's origin that holds it [m]; ∞ for walls.
double bounding_radius(const Shape& shape);

/// A box around a particle, aligned with its body frame. Throws InputError for walls.
OrientedBox oriented_box(const Shape& shape);

/// Volume, centroid and inertia; throws InputError for walls.
MassProperties mass_properties(const Shape& shape);

}  // namespace osculate
