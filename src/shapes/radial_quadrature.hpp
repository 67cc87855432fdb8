#pragma once
// Mass properties of a body that every ray from the origin leaves once, by adaptive quadrature over directions.

#include <functional>

#include "osculate/shapes/surface.hpp"

namespace osculate {

/// How hard to try: refinement ends at the first of the two.
struct QuadratureEffort {
  double relative_error = 1e-9;  ///< of volume and of second moments
  int evaluations = 1'000'000;
};

/// `stretch(x)` > 0 takes x ≠ 0 to the surface: stretch(x) · x is the surface point on its ray.
///   V = ∫ ρ³/3 dΩ,  ∫ x dV = ∫ ρ⁴/4 u dΩ,  ∫ x xᵀ dV = ∫ ρ⁵/5 u uᵀ dΩ
/// The reported error is the sum over cells of the differences between two resolutions, of which the finer is used; it
/// is cautious where the surface has kinks.
MassProperties mass_properties_by_quadrature(const std::function<double(const Vec3&)>& stretch,
                                             const QuadratureEffort& effort = {});

}  // namespace osculate
