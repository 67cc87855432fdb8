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

/// Radius of a sphere about the body's origin that holds it [m]; ∞ for walls.
double bounding_radius(const Shape& shape);

/// Volume, centroid and inertia; throws InputError for walls.
MassProperties mass_properties(const Shape& shape);

}  // namespace osculate
