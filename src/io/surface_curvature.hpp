#pragma once
// A shape's surface with its curvatures at every vertex, for files and pictures.

#include <string_view>
#include <vector>

#include "osculate/geometry/curvature.hpp"
#include "osculate/shapes/mesh.hpp"

namespace osculate::io {

enum class CurvatureKind {
  mean,
  gaussian,
  max,
};

std::string_view name(CurvatureKind kind);

struct CurvedSurface {
  TriangleMesh mesh;
  std::vector<PrincipalCurvatures> curvatures;  ///< one a vertex, body frame
};

/// `resolution` as for surface_mesh.
CurvedSurface curved_surface(const Shape& shape, int resolution);

/// One number a vertex [1/m], Gaussian [1/m²].
std::vector<double> values(const CurvedSurface& surface, CurvatureKind kind);

/// The value below which a given fraction of the surface's area lies; `fraction` in [0, 1].
double area_quantile(const TriangleMesh& mesh, const std::vector<double>& values, double fraction);

/// Area of the triangles [m²]; below the surface's by a part that falls as 1/resolution².
double area(const TriangleMesh& mesh);

}  // namespace osculate::io
