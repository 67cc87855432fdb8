#include "io/curvature_scale.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/units.hpp"

namespace osculate::io {

ScalarRange colour_range(const CurvedSurface& surface, const std::vector<double>& scalars) {
  double lower = area_quantile(surface.mesh, scalars, 0.01), upper = area_quantile(surface.mesh, scalars, 0.99);
  if (lower >= 0.0 && lower < 0.25 * upper) lower = 0.0;
  constexpr double constant = 1e-6;  // relative: what rounding makes of a sphere
  if (upper - lower > constant * std::fabs(upper)) return {lower, upper};
  const double around = upper != 0.0 ? 0.5 * std::fabs(upper) : 1.0;
  return {upper - around, upper + around};
}

CurvaturePicture picture_of(const CurvedSurface& surface, CurvatureKind kind) {
  double radius = 0.0;
  for (const Vec3& vertex : surface.mesh.vertices) radius = std::max(radius, vertex.norm());
  const Unit unit = suitable_length(radius);
  const double factor = kind == CurvatureKind::gaussian ? unit.in_si * unit.in_si : unit.in_si;
  const char* const power = kind == CurvatureKind::gaussian ? "²" : "";
  const std::string title = fmt::format("{} curvature (1/{}{})",
                                        kind == CurvatureKind::gaussian ? "Gaussian" : name(kind), unit.symbol, power);
  std::vector<double> scalars = values(surface, kind);
  const ScalarRange range = colour_range(surface, scalars);
  for (double& value : scalars) value *= factor;
  return {{.mesh = surface.mesh, .scalars = std::move(scalars)},
          {.title = title, .lower = range.lower * factor, .upper = range.upper * factor}};
}

}  // namespace osculate::io
