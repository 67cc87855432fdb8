#include "io/shape_properties.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace osculate::io {

ShapeProperties measure(const Shape& shape, const CurvedSurface& surface, int resolution) {
  const MassProperties mass = mass_properties(shape);
  const double radius = volume_equivalent_radius(mass.volume);
  // A mesh's area falls short by a part that goes with the square of its cell size.
  const double fine = area(surface.mesh), coarse = area(surface_mesh(shape, std::max(2, resolution / 2)));
  const double difference = fine - coarse;
  const double extrapolated = fine + difference / 3.0;
  const auto smallest = std::ranges::min_element(surface.curvatures, {}, &PrincipalCurvatures::min);
  const auto largest = std::ranges::max_element(surface.curvatures, {}, &PrincipalCurvatures::max);
  return {.mass = mass,
          .equivalent_radius = radius,
          .bounding_radius = bounding_radius(shape),
          .box = oriented_box(shape),
          .area = extrapolated,
          .area_error = std::fabs(difference),
          .sphericity = 4.0 * std::numbers::pi * radius * radius / extrapolated,
          .smallest_curvature = smallest->min,
          .largest_curvature = largest->max};
}

}  // namespace osculate::io
