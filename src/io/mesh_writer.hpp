#pragma once
// Surfaces for other programs: Wavefront OBJ, and VTK PolyData (.vtp) for ParaView.

#include <filesystem>

#include "io/surface_curvature.hpp"

namespace osculate::io {

/// Vertices [m] with a viridis colour by `colour` (the common "v x y z r g b" extension), normals, triangles.
void write_obj(const CurvedSurface& surface, CurvatureKind colour, const std::filesystem::path& path);

/// VTK XML PolyData, ascii, 17 digits: points [m], point data k_max, k_min, mean_curvature [1/m],
/// gaussian_curvature [1/m²], k_max_direction and Normals; `colour` is the active scalar.
void write_vtp(const CurvedSurface& surface, CurvatureKind colour, const std::filesystem::path& path);

}  // namespace osculate::io
