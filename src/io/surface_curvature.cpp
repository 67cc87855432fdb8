#include "io/surface_curvature.hpp"

#include <algorithm>
#include <utility>

namespace osculate::io {
namespace {

double area(const TriangleMesh& mesh, const std::array<int, 3>& corners) {
  const auto at = [&](std::size_t i) -> const Vec3& { return mesh.vertices[static_cast<std::size_t>(corners[i])]; };
  return 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
}

}  // namespace

std::string_view name(CurvatureKind kind) {
  switch (kind) {
    case CurvatureKind::mean:
      return "mean";
    case CurvatureKind::gaussian:
      return "gaussian";
    case CurvatureKind::max:
      return "max";
  }
  return "";
}

CurvedSurface curved_surface(const Shape& shape, int resolution) {
  CurvedSurface surface{surface_mesh(shape, resolution), {}};
  surface.curvatures.reserve(surface.mesh.vertices.size());
  for (const Vec3& vertex : surface.mesh.vertices) surface.curvatures.push_back(principal_curvatures(shape, vertex));
  return surface;
}

std::vector<double> values(const CurvedSurface& surface, CurvatureKind kind) {
  std::vector<double> found;
  found.reserve(surface.curvatures.size());
  for (const PrincipalCurvatures& curvature : surface.curvatures) {
    found.push_back(kind == CurvatureKind::mean       ? curvature.mean()
                    : kind == CurvatureKind::gaussian ? curvature.gaussian()
                                                      : curvature.max);
  }
  return found;
}

double area_quantile(const TriangleMesh& mesh, const std::vector<double>& values, double fraction) {
  std::vector<std::pair<double, double>> value_and_area(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) value_and_area[i] = {values[i], 0.0};
  for (const auto& corners : mesh.triangles) {
    const double third = area(mesh, corners) / 3.0;
    for (const int corner : corners) value_and_area[static_cast<std::size_t>(corner)].second += third;
  }
  std::sort(value_and_area.begin(), value_and_area.end());
  const double wanted = fraction * area(mesh);
  double below = 0.0;
  for (const auto& [value, around] : value_and_area) {
    below += around;
    if (below >= wanted) return value;
  }
  return value_and_area.back().first;
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& corners : mesh.triangles) sum += area(mesh, corners);
  return sum;
}

}  // namespace osculate::io
