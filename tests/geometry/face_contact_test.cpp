#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "osculate/core/error.hpp"
#include "osculate/geometry/common_normal.hpp"
#include "osculate/geometry/mesh_surface.hpp"

using namespace osculate;

namespace {

Vec3 random_vector(double size, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-size, size);
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return {x, y, z};
}

Quat random_orientation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Quat(w, x, y, z).normalized();
}

/// Cells of [−1, 1]², each of two triangles; inner corners moved at random by `jitter` of a cell, in the plane.
SurfaceTriangles sheet(int cells, double jitter) {
  std::mt19937_64 random(4);
  SurfaceTriangles mesh;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      Vec3 corner(-1.0 + 2.0 * i / cells, -1.0 + 2.0 * j / cells, 0.0);
      const Vec3 moved = random_vector(jitter * 2.0 / cells, random);
      if (i > 0 && i < cells && j > 0 && j < cells) corner += Vec3(moved.x(), moved.y(), 0.0);
      mesh.vertices.push_back(corner);
    }
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({d, a, c});  // turned the other way
    }
  return mesh;
}

/// The cube [−1, 1]³ as another program may write it: every triangle with corners of its own.
SurfaceTriangles cube() {
  SurfaceTriangles mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto corner = [&](double s, double t) {
        Vec3 x = Vec3::Zero();
        x[axis] = side, x[(axis + 1) % 3] = s, x[(axis + 2) % 3] = t;
        return x;
      };
      for (const auto& triangle : {std::array{corner(-1, -1), corner(1, -1), corner(1, 1)},
                                   std::array{corner(-1, -1), corner(1, 1), corner(-1, 1)}}) {
        const int first = static_cast<int>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), triangle.begin(), triangle.end());
        mesh.triangles.push_back({first, first + 1, first + 2});
      }
    }
  return mesh;
}

std::vector<ContactGeometry> active(const Shape& shape, const Pose& pose, const MeshSurface& surface,
                                    const Pose& surface_pose, double reach = 0.0) {
  std::vector<ContactGeometry> contacts;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const FaceContact found = face_contact(shape, pose, surface, surface_pose, static_cast<int>(f), reach);
    if (found.is_active) contacts.push_back(found.contact);
  }
  return contacts;
}

double distance_to_cube(const Vec3& x) {
  return (x.cwiseAbs() - Vec3::Ones()).cwiseMax(0.0).norm();
}

}  // namespace

TEST_CASE("A plane of triangles is the plane: one of them makes the contact, to round-off the same") {
  const MeshSurface surface = mesh_surface(sheet(12, 0.3));
  const Pose placed{.position = {0.3, -0.2, 0.7}, .orientation = Quat(0.4, -0.2, 0.8, 0.1).normalized()};
  const Shape shape = GENERATE(Shape(Sphere{0.11}), Shape(Ellipsoid{{0.15, 0.1, 0.07}}),
                               Shape(Superquadric{{0.1, 0.12, 0.14}, {5.0, 4.0}}));
  std::mt19937_64 random(8);
  int symmetric = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Vec3 over = random_vector(0.6, random);
    const Quat turn = random_orientation(random);
    // Some stand exactly over corners and edges.
    const bool on_corner = trial % 3 == 0 && std::holds_alternative<Sphere>(shape);
    if (on_corner) over = surface.vertices[static_cast<std::size_t>(40 + trial % 60)].at;
    const double above =
        (trial % 2 == 0 ? 1.0 : -1.0) * (-(turn * support_point(shape, turn.conjugate() * -Vec3::UnitZ())).z() - 1e-3);
    over.z() = above;
    if (above < 0.0)  // from below: its highest point counts
      over.z() = -((turn * support_point(shape, turn.conjugate() * Vec3::UnitZ())).z() - 1e-3);
    const Pose pose{.position = placed.to_world(over), .orientation = placed.orientation * turn};
    const auto contacts = active(shape, pose, surface, placed);
    INFO("trial " << trial);
    REQUIRE(contacts.size() == 1);
    symmetric += on_corner ? 1 : 0;
    Pose plane = placed;
    if (above < 0.0) plane.orientation = plane.orientation * Quat(0.0, 1.0, 0.0, 0.0);
    const ContactGeometry expected = common_normal(shape, pose, HalfSpace{}, plane);
    CHECK(std::fabs(contacts[0].overlap - expected.overlap) < 1e-14);
    CHECK(contacts[0].overlap == Approx(1e-3).epsilon(1e-9));
    CHECK((contacts[0].normal - expected.normal).norm() < 1e-14);
    CHECK((contacts[0].point() - expected.point()).norm() < 1e-13);
    CHECK(contacts[0].relative.R_i == Approx(expected.relative.R_i).epsilon(1e-9));
    CHECK(contacts[0].relative.R_j == Approx(expected.relative.R_j).epsilon(1e-9));
  }
  CHECK((symmetric > 0 || !std::holds_alternative<Sphere>(shape)));
}

TEST_CASE("A ball touches a cube's faces, edges and corners once, at its distance from the cube") {
  const MeshSurface surface = mesh_surface(cube());
  REQUIRE(surface.faces.size() == 12);
  REQUIRE(surface.vertices.size() == 8);
  REQUIRE(surface.edges.size() == 18);
  constexpr double radius = 0.3;
  std::mt19937_64 random(2);
  int faces = 0, edges = 0, corners = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Vec3 centre = random_vector(1.3, random);
    const double distance = distance_to_cube(centre), overlap = radius - distance;
    if (overlap < 1e-6 || overlap > 0.1) continue;
    const auto contacts = active(Sphere{radius}, {.position = centre}, surface, {});
    REQUIRE(contacts.size() == 1);
    const Vec3 nearest = centre.cwiseMax(-1.0).cwiseMin(1.0);
    CHECK(std::fabs(contacts[0].overlap - overlap) < 1e-9);
    CHECK((contacts[0].normal - (nearest - centre) / distance).norm() < 1e-6);
    CHECK((contacts[0].on_2 - nearest).norm() < 1e-6);
    CHECK(contacts[0].relative.R_i == Approx(radius).epsilon(1e-6));
    CHECK(contacts[0].relative.R_j == Approx(radius).epsilon(1e-6));
    const auto beyond = (centre.array().abs() > 1.0).count();
    faces += beyond == 1 ? 1 : 0, edges += beyond == 2 ? 1 : 0, corners += beyond == 3 ? 1 : 0;
  }
  CHECK(faces > 100);
  CHECK(edges > 50);
  CHECK(corners > 10);
}

TEST_CASE("An ellipsoid's contact with a cube is the direction of least overlap") {
  const MeshSurface surface = mesh_surface(cube());
  const Ellipsoid shape{{0.4, 0.3, 0.2}};
  std::mt19937_64 random(5);
  int found = 0;
  for (int trial = 0; trial < 4000 && found < 60; ++trial) {
    const Pose pose{.position = random_vector(1.4, random), .orientation = random_orientation(random)};
    const auto contacts = active(shape, pose, surface, {});
    if (contacts.empty() || contacts[0].overlap > 0.03 || distance_to_cube(pose.position) < 0.1) continue;
    ++found;
    REQUIRE(contacts.size() == 1);
    // Overlap along u, from the particle to the cube: there is none less than along the normal.
    const auto overlap = [&](const Vec3& u) {
      const Vec3 of_particle = pose.to_world(support_point(Shape(shape), pose.rotate_to_body(u)));
      return of_particle.dot(u) + u.cwiseAbs().sum();
    };
    CHECK(contacts[0].overlap == Approx(overlap(contacts[0].normal)).margin(1e-9));
    CHECK((contacts[0].on_1 - contacts[0].on_2 - contacts[0].overlap * contacts[0].normal).norm() < 1e-9);
    double least = 1.0;
    Vec3 best = contacts[0].normal;
    for (double size = 1.0; size > 1e-6; size *= 0.9)
      for (int k = 0; k < 20; ++k) {
        const Vec3 next = (best + random_vector(size, random)).normalized();
        least = std::min(least, overlap(next));
        if (overlap(next) < overlap(best)) best = next;
      }
    CHECK(least > contacts[0].overlap - 1e-9);
  }
  CHECK(found == 60);
}

TEST_CASE("The contact goes over from face to edge to face without a jump") {
  // Ellipsoids that slide over a ridge of the cube.
  const MeshSurface surface = mesh_surface(cube());
  const Ellipsoid shape{{0.25, 0.2, 0.15}};
  std::mt19937_64 random(6);
  for (int path = 0; path < 10; ++path) {
    const Quat turn = random_orientation(random);
    const double along = 0.3 * path / 10.0;
    std::vector<ContactGeometry> before;
    constexpr int places = 2000;
    for (int i = 0; i <= places; ++i) {
      // The way of the centre keeps the overlap at most small: a curve around the ridge.
      const double angle = -0.3 + (1.5707963 + 0.6) * i / places;
      const Vec3 normal(std::sin(angle), 0.0, std::cos(angle));
      const Vec3 deepest = turn * support_point(Shape(shape), turn.conjugate() * -normal);
      const Vec3 on_ridge(0.99, along, 0.99);
      const Vec3 shift = angle < 0.0 ? Vec3(0.5 * angle, 0, 0)
                                     : (angle > 1.5707963 ? Vec3(0, 0, 0.5 * (1.5707963 - angle)) : Vec3::Zero());
      const auto contacts = active(shape, {.position = on_ridge + shift - deepest, .orientation = turn}, surface, {});
      REQUIRE(contacts.size() <= 1);
      if (!before.empty() && !contacts.empty()) {
        CHECK(std::fabs(contacts[0].overlap - before[0].overlap) < 2e-3 * 0.25);
        CHECK((contacts[0].normal - before[0].normal).norm() < 2e-2);
        CHECK((contacts[0].relative.R_i - before[0].relative.R_i) < 0.05 * contacts[0].relative.R_i);
      }
      before = contacts;
    }
    CHECK(before.size() == 1);
  }
}

TEST_CASE("In a valley a ball touches both slopes") {
  SurfaceTriangles valley;
  valley.vertices = {{0, -1, 0}, {0, 1, 0}, {1, -1, 1}, {1, 1, 1}, {-1, -1, 1}, {-1, 1, 1}};
  valley.triangles = {{0, 1, 3}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}};
  const MeshSurface surface = mesh_surface(valley);
  const double radius = 0.2;
  const auto contacts = active(Sphere{radius}, {.position = {0.0, 0.1, std::sqrt(2.0) * (radius - 1e-3)}}, surface, {});
  REQUIRE(contacts.size() == 2);
  CHECK(contacts[0].overlap == Approx(1e-3));
  CHECK(contacts[1].overlap == Approx(1e-3));
  CHECK(contacts[0].normal.dot(contacts[1].normal) == Approx(0.0).margin(1e-12));
}

TEST_CASE("A face that is not touched says how far it is at least") {
  const MeshSurface surface = mesh_surface(cube());
  const Ellipsoid shape{{0.4, 0.3, 0.2}};
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    const Pose pose{.position = 2.5 * random_vector(1.0, random), .orientation = random_orientation(random)};
    const double distance = distance_to_cube(pose.position);
    if (distance < 0.41) continue;
    for (int face = 0; face < 12; ++face) {
      const FaceContact found = face_contact(shape, pose, surface, {}, face, 0.0);
      REQUIRE(!found.is_active);
      REQUIRE(-found.contact.overlap > 0.0);
      const double to_face = distance_to(surface.faces[static_cast<std::size_t>(face)], pose.position);
      REQUIRE(-found.contact.overlap <= to_face - 0.2);
    }
  }
}

TEST_CASE("Meshes that are none are refused") {
  CHECK_THROWS_AS(mesh_surface({}), InputError);
  CHECK_THROWS_WITH(mesh_surface({.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 3}}}),
                    Catch::Matchers::Contains("triangle 0 with vertex 3"));
  CHECK_THROWS_WITH(mesh_surface({.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, .triangles = {{0, 1, 2}}}),
                    Catch::Matchers::Contains("no triangle with an area"));
}
