#include "io/mesh_writer.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "io/atomic_file.hpp"
#include "io/colour.hpp"
#include "io/curvature_scale.hpp"
#include "osculate/core/error.hpp"

namespace osculate::io {
namespace {

std::string_view field_name(CurvatureKind kind) {
  return kind == CurvatureKind::mean       ? "mean_curvature"
         : kind == CurvatureKind::gaussian ? "gaussian_curvature"
                                           : "k_max";
}

/// One VTK data array of `columns` numbers a row; row(i, out) appends them.
template <class Row>
void data_array(std::string& text, std::string_view type, std::string_view name, int columns, std::size_t rows,
                const Row& row) {
  fmt::format_to(std::back_inserter(text),
                 "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type, name,
                 columns);
  for (std::size_t i = 0; i < rows; ++i) {
    row(i);
    text += '\n';
  }
  text += "</DataArray>\n";
}

}  // namespace

void write_obj(const CurvedSurface& surface, CurvatureKind colour, const std::filesystem::path& path) {
  const std::vector<double> scalars = values(surface, colour);
  const ScalarRange range = colour_range(surface, scalars);
  std::string text =
      fmt::format("# Osculate surface; lengths in m; vertex colours: {} curvature, viridis from {:.6g} to {:.6g}\n",
                  name(colour), range.lower, range.upper);
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < surface.mesh.vertices.size(); ++i) {
    const Vec3& v = surface.mesh.vertices[i];
    const Colour c = viridis((scalars[i] - range.lower) / (range.upper - range.lower));
    fmt::format_to(out, "v {:.17g} {:.17g} {:.17g} {:.4f} {:.4f} {:.4f}\n", v.x(), v.y(), v.z(), c.red, c.green,
                   c.blue);
  }
  for (const Vec3& n : surface.mesh.normals) fmt::format_to(out, "vn {:.9g} {:.9g} {:.9g}\n", n.x(), n.y(), n.z());
  for (const auto& t : surface.mesh.triangles) {
    fmt::format_to(out, "f {0}//{0} {1}//{1} {2}//{2}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  }
  write_atomically(path.string(), text);
}

void write_vtp(const CurvedSurface& surface, CurvatureKind colour, const std::filesystem::path& path) {
  const std::size_t points = surface.mesh.vertices.size(), triangles = surface.mesh.triangles.size();
  std::string text;
  const auto out = std::back_inserter(text);
  const auto scalars = [&](std::string_view name, const auto& value) {
    data_array(text, "Float64", name, 1, points,
               [&](std::size_t i) { fmt::format_to(out, "{:.17g}", value(surface.curvatures[i])); });
  };
  const auto vectors = [&](std::string_view name, const auto& value) {
    data_array(text, "Float64", name, 3, points, [&](std::size_t i) {
      const Vec3 v = value(i);
      fmt::format_to(out, "{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
    });
  };
  fmt::format_to(
      out,
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n<PointData Scalars=\"{}\" Normals=\"Normals\">\n",
      points, triangles, field_name(colour));
  scalars("k_max", [](const PrincipalCurvatures& k) { return k.max; });
  scalars("k_min", [](const PrincipalCurvatures& k) { return k.min; });
  scalars("mean_curvature", [](const PrincipalCurvatures& k) { return k.mean(); });
  scalars("gaussian_curvature", [](const PrincipalCurvatures& k) { return k.gaussian(); });
  vectors("k_max_direction", [&](std::size_t i) { return surface.curvatures[i].max_direction; });
  vectors("Normals", [&](std::size_t i) { return surface.mesh.normals[i]; });
  text += "</PointData>\n<Points>\n";
  vectors("Points", [&](std::size_t i) { return surface.mesh.vertices[i]; });
  text += "</Points>\n<Polys>\n";
  data_array(text, "Int64", "connectivity", 1, triangles, [&](std::size_t i) {
    const auto& t = surface.mesh.triangles[i];
    fmt::format_to(out, "{} {} {}", t[0], t[1], t[2]);
  });
  data_array(text, "Int64", "offsets", 1, triangles, [&](std::size_t i) { fmt::format_to(out, "{}", 3 * (i + 1)); });
  text += "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  write_atomically(path.string(), text);
}

}  // namespace osculate::io
