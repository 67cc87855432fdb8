#include "osculate/geometry/mesh_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "osculate/core/error.hpp"

namespace osculate {
namespace {

/// Below this share of the surface's size two vertices are one, and below its square a triangle has no area.
constexpr double negligible = 1e-6;

/// Two faces are in one plane if the sine of the angle between them is below this.
constexpr double flat = 1e-7;

using Cell = std::array<std::int64_t, 3>;

/// Gives vertices that stand together one number.
class Welder {
 public:
  explicit Welder(double tolerance) : tolerance_(tolerance) {}

  int number(const Vec3& point) {
    const Cell middle = cell_of(point);
    for (std::int64_t k = 0; k < 27; ++k) {
      const auto near = cells_.find({middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
      if (near == cells_.end()) continue;
      for (const int other : near->second)
        if ((points[static_cast<std::size_t>(other)] - point).norm() <= tolerance_) return other;
    }
    const int added = static_cast<int>(points.size());
    points.push_back(point);
    cells_[middle].push_back(added);
    return added;
  }

  std::vector<Vec3> points;

 private:
  Cell cell_of(const Vec3& point) const {
    Cell cell{};
    for (std::size_t k = 0; k < 3; ++k)
      cell[k] = static_cast<std::int64_t>(std::floor(point[static_cast<Eigen::Index>(k)] / tolerance_));
    return cell;
  }

  double tolerance_;
  std::map<Cell, std::vector<int>> cells_;
};

double size_of(const SurfaceTriangles& mesh) {
  if (mesh.vertices.empty()) throw InputError("mesh", "no vertices", "three at least");
  Vec3 lower = mesh.vertices[0], upper = lower;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    if (!mesh.vertices[i].allFinite())
      throw InputError("mesh", "vertex " + std::to_string(i) + " that is not finite", "finite coordinates");
    lower = lower.cwiseMin(mesh.vertices[i]);
    upper = upper.cwiseMax(mesh.vertices[i]);
  }
  return (upper - lower).norm();
}

SurfaceFace make_face(const std::array<Vec3, 3>& corners, const std::array<int, 3>& vertices) {
  SurfaceFace face{.corners = corners,
                   .normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized(),
                   .outward = {},
                   .edges = {},
                   .vertices = vertices,
                   .neighbours = {},
                   .centre = (corners[0] + corners[1] + corners[2]) / 3.0,
                   .radius = 0.0};
  for (std::size_t k = 0; k < 3; ++k) {
    face.outward[k] = (corners[(k + 1) % 3] - corners[k]).cross(face.normal).normalized();
    face.radius = std::max(face.radius, (corners[k] - face.centre).norm());
  }
  return face;
}

void add_edges(MeshSurface& surface, const std::vector<Vec3>& points) {
  std::map<std::pair<int, int>, int> numbers;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    SurfaceFace& face = surface.faces[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [first, last] = std::minmax(face.vertices[k], face.vertices[(k + 1) % 3]);
      const auto [found, is_new] = numbers.try_emplace({first, last}, static_cast<int>(surface.edges.size()));
      if (is_new) {
        const Vec3 &from = points[static_cast<std::size_t>(first)], &to = points[static_cast<std::size_t>(last)];
        const Vec3 direction = (to - from).normalized();
        surface.edges.push_back({.from = from,
                                 .direction = direction,
                                 .length = (to - from).norm(),
                                 .faces = {},
                                 .into = {},
                                 .pose = {from, Quat::FromTwoVectors(Vec3::UnitZ(), direction)},
                                 .is_flat = false});
      }
      SurfaceEdge& edge = surface.edges[static_cast<std::size_t>(found->second)];
      face.edges[k] = found->second;
      edge.faces.push_back(static_cast<int>(f));
      edge.into.push_back(-face.outward[k]);
    }
  }
  for (SurfaceEdge& edge : surface.edges)
    edge.is_flat = edge.faces.size() == 2 && (edge.into[0] + edge.into[1]).norm() < flat;
}

void add_vertices(MeshSurface& surface, const std::vector<Vec3>& points) {
  for (const Vec3& point : points) surface.vertices.push_back({point, {}, {}, true});
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    for (const int vertex : surface.faces[f].vertices)
      surface.vertices[static_cast<std::size_t>(vertex)].faces.push_back(static_cast<int>(f));
  for (SurfaceFace& face : surface.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::vector<int>& around = surface.vertices[static_cast<std::size_t>(face.vertices[k])].faces;
      face.neighbours.insert(face.neighbours.end(), around.begin(), around.end());
    }
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    std::vector<int>& neighbours = surface.faces[f].neighbours;
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    std::erase(neighbours, static_cast<int>(f));
  }
  for (const SurfaceFace& face : surface.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      SurfaceVertex& vertex = surface.vertices[static_cast<std::size_t>(face.vertices[k])];
      // Every edge is met by each of its faces: twice the same direction does no harm.
      vertex.along.push_back((face.corners[(k + 1) % 3] - face.corners[k]).normalized());
      vertex.along.push_back((face.corners[(k + 2) % 3] - face.corners[k]).normalized());
      for (const int edge : {face.edges[k], face.edges[(k + 2) % 3]})
        vertex.is_flat = vertex.is_flat && surface.edges[static_cast<std::size_t>(edge)].is_flat;
    }
}

}  // namespace

MeshSurface mesh_surface(const SurfaceTriangles& mesh) {
  const double size = size_of(mesh);
  if (!(size > 0.0)) throw InputError("mesh", "vertices in one place", "triangles with an area");
  Welder welder(negligible * size);
  MeshSurface surface;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<int, 3> vertices{};
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const int index = mesh.triangles[t][k];
      if (index < 0 || static_cast<std::size_t>(index) >= mesh.vertices.size())
        throw InputError("mesh", "triangle " + std::to_string(t) + " with vertex " + std::to_string(index),
                         "one of " + std::to_string(mesh.vertices.size()));
      vertices[k] = welder.number(mesh.vertices[static_cast<std::size_t>(index)]);
      corners[k] = welder.points[static_cast<std::size_t>(vertices[k])];
    }
    const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    if (area > negligible * negligible * size * size) surface.faces.push_back(make_face(corners, vertices));
  }
  if (surface.faces.empty()) throw InputError("mesh", "no triangle with an area", "one at least");
  add_edges(surface, welder.points);
  add_vertices(surface, welder.points);
  return surface;
}

double distance_to(const SurfaceFace& face, const Vec3& point) {
  const double height = face.normal.dot(point - face.corners[0]);
  double beyond = 0.0;  // the nearest point of the plane lies outside of the face
  bool inside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &from = face.corners[k], &to = face.corners[(k + 1) % 3];
    if (face.outward[k].dot(point - from) <= 0.0) continue;
    const Vec3 way = to - from;
    const double along = std::clamp(way.dot(point - from) / way.squaredNorm(), 0.0, 1.0);
    const double apart = (point - from - along * way).norm();
    beyond = inside ? apart : std::min(beyond, apart);
    inside = false;
  }
  return inside ? std::fabs(height) : beyond;
}

}  // namespace osculate
