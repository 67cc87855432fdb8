#include "osculate/shapes/mesh.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <type_traits>

#include "osculate/core/error.hpp"
#include "shapes/mesh_map.hpp"

namespace osculate {
namespace {

using GridPoint = std::array<int, 3>;  // on the surface of the cube [−half, half]³

/// Neighbouring cells see nearly equal angles from the centre, and the symmetry planes are grid lines.
Vec3 direction_of(const GridPoint& point, int half) {
  const auto coordinate = [&](int i) { return std::tan(0.25 * std::numbers::pi * i / half); };
  return {coordinate(point[0]), coordinate(point[1]), coordinate(point[2])};
}

/// Numbers the cube's grid points as they come, so that faces share the vertices of their edges.
class CubeGrid {
 public:
  explicit CubeGrid(int half) : half_(half) {}

  int index_of(const GridPoint& point) {
    const auto [place, is_new] = indices_.try_emplace(point, static_cast<int>(directions.size()));
    if (is_new) directions.push_back(direction_of(point, half_));
    return place->second;
  }

  std::vector<Vec3> directions;

 private:
  int half_;
  std::map<GridPoint, int> indices_;
};

template <class S>
void place_vertices(const S& shape, const std::vector<Vec3>& directions, TriangleMesh& mesh) {
  mesh.vertices.reserve(directions.size());
  mesh.normals.reserve(directions.size());
  for (const Vec3& direction : directions) {
    mesh.vertices.push_back(mesh_point(shape, direction));
    mesh.normals.push_back(gauge(shape, mesh.vertices.back()).gradient.normalized());
  }
}

}  // namespace

TriangleMesh surface_mesh(const Shape& shape, int resolution) {
  if (!is_particle(shape)) {
    throw InputError("surface mesh", "a wall (" + std::string(kind(shape)) + ")", "a particle");
  }
  if (resolution < 2 || resolution > 2048) {
    throw InputError("surface mesh", "resolution = " + std::to_string(resolution), "2 to 2048 cells along an edge");
  }
  const int half = (resolution + 1) / 2;
  CubeGrid grid(half);
  TriangleMesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      // (first, second, axis · side) is right-handed.
      const std::size_t first = (axis + (side > 0 ? 1 : 2)) % 3, second = (axis + (side > 0 ? 2 : 1)) % 3;
      const auto corner = [&](int i, int j) {
        GridPoint point{};
        point[axis] = side * half;
        point[first] = i;
        point[second] = j;
        return grid.index_of(point);
      };
      for (int i = -half; i < half; ++i) {
        for (int j = -half; j < half; ++j) {
          const int a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
          // Diagonals run towards the cube's corners in every quadrant.
          if ((i < 0) == (j < 0)) {
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
          } else {
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {b, c, d}});
          }
        }
      }
    }
  }
  std::visit(
      [&](const auto& s) {
        if constexpr (requires { as_superquadric(s); }) {
          place_vertices(as_superquadric(s), grid.directions, mesh);
        } else if constexpr (requires { mesh_point(s, Vec3()); }) {
          place_vertices(s, grid.directions, mesh);
        }
      },
      shape);
  return mesh;
}

}  // namespace osculate
