#include "osculate/shapes/mesh.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "osculate/core/error.hpp"
#include "shapes/sample_shapes.hpp"

using namespace osculate;

namespace {

Vec3 corner(const TriangleMesh& mesh, const std::array<int, 3>& triangle, std::size_t i) {
  return mesh.vertices[static_cast<std::size_t>(triangle[i])];
}

double enclosed_volume(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
    volume += corner(mesh, t, 0).dot(corner(mesh, t, 1).cross(corner(mesh, t, 2))) / 6.0;
  return volume;
}

}  // namespace

TEST_CASE("A surface mesh is closed, faces outward and lies on the surface") {
  for (const Shape& shape : samples::particles()) {
    CAPTURE(kind(shape), bounding_radius(shape));
    const TriangleMesh mesh = surface_mesh(shape, 12);
    CHECK(mesh.triangles.size() == 12 * 12 * 12);
    CHECK(mesh.vertices.size() == mesh.triangles.size() / 2 + 2);  // Euler: V − E + F = 2, E = 3F/2
    CHECK(mesh.normals.size() == mesh.vertices.size());
    std::set<std::pair<int, int>> edges;
    int turned_in = 0;
    for (const auto& t : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) edges.emplace(t[i], t[(i + 1) % 3]);
      const Vec3 area = (corner(mesh, t, 1) - corner(mesh, t, 0)).cross(corner(mesh, t, 2) - corner(mesh, t, 0));
      Vec3 normal = Vec3::Zero();
      for (const int vertex : t) normal += mesh.normals[static_cast<std::size_t>(vertex)];
      if (!(area.dot(normal) > 0.0)) ++turned_in;
    }
    CHECK(turned_in == 0);
    CHECK(edges.size() == 3 * mesh.triangles.size());                          // every directed edge once …
    for (const auto& [from, to] : edges) CHECK(edges.count({to, from}) == 1);  // … and its neighbour has it reversed
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      CHECK(std::fabs(gauge(shape, mesh.vertices[i]).value - 1.0) < 1e-13);
      CHECK(std::fabs(mesh.normals[i].norm() - 1.0) < 1e-14);
    }
  }
}

TEST_CASE("The volume in a mesh converges to the body's with the square of the cell") {
  for (const Shape& shape : samples::particles()) {
    CAPTURE(kind(shape), bounding_radius(shape));
    const double volume = mass_properties(shape).volume;
    const double coarse = 1.0 - enclosed_volume(surface_mesh(shape, 24)) / volume;
    const double fine = 1.0 - enclosed_volume(surface_mesh(shape, 48)) / volume;
    CHECK(coarse > 0.0);  // chords cut corners off
    CHECK(coarse < 0.01);
    CHECK(coarse / fine > 3.2);  // 4 but for rims and kinks, where the surface is less smooth
  }
}

TEST_CASE("Neighbouring normals of a mesh differ little, on boxes and octahedra too") {
  // A quarter turn over an edge of a box takes several cells at resolution 32, so that shading shows it round.
  for (const double n : {2.0, 4.0, 12.0, 50.0}) {
    const TriangleMesh mesh = surface_mesh(Superquadric{Vec3(1, 1, 1), {n, n}}, 32);
    double least = 1.0;
    for (const auto& t : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        least = std::min(least, mesh.normals[static_cast<std::size_t>(t[i])].dot(
                                    mesh.normals[static_cast<std::size_t>(t[(i + 1) % 3])]));
      }
    }
    CHECK(least > std::cos(0.35));
  }
}

TEST_CASE("Triangles of a mesh are no slivers") {
  for (const double n : {1.1, 1.5, 2.0, 6.0, 12.0, 50.0}) {
    const TriangleMesh mesh = surface_mesh(Superquadric{Vec3(1, 1, 1), {n, n}}, 24);
    double thinnest = 1.0;
    for (const auto& t : mesh.triangles) {
      const Vec3 a = corner(mesh, t, 1) - corner(mesh, t, 0), b = corner(mesh, t, 2) - corner(mesh, t, 1);
      const double longest = std::max({a.norm(), b.norm(), (a + b).norm()});
      thinnest = std::min(thinnest, a.cross(b).norm() / (longest * longest));
    }
    CHECK(thinnest > 0.03);  // height over length
  }
}

TEST_CASE("Meshes of walls, and of absurd resolution, are refused") {
  CHECK_THROWS_AS(surface_mesh(HalfSpace{}, 8), InputError);
  CHECK_THROWS_AS(surface_mesh(Sphere{1.0}, 1), InputError);
  CHECK_THROWS_AS(surface_mesh(Sphere{1.0}, 100'000), InputError);
  CHECK(surface_mesh(Sphere{1.0}, 3).triangles.size() == 12 * 4 * 4);  // rounded up to an even number
}
