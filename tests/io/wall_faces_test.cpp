#include "io/wall_faces.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace osculate;
using namespace osculate::io;

namespace {

Pose facing(const Vec3& position, const Vec3& normal) {
  return {position, Quat::FromTwoVectors(Vec3::UnitZ(), normal)};
}

/// Twice the vector area of a polygon is the sum of its triangles' cross products.
Vec3 area_vector(const std::vector<Vec3>& corners) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += 0.5 * (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  return sum;
}

constexpr int around = 96;

}  // namespace

TEST_CASE("An open box of five planes shows five rectangles that face inwards, and their twelve edges") {
  const std::vector<PlacedShape> walls{{HalfSpace{}, facing({0, 0, 0}, Vec3::UnitZ())},
                                       {HalfSpace{}, facing({0, 0, 0}, Vec3::UnitX())},
                                       {HalfSpace{}, facing({2, 0, 0}, -Vec3::UnitX())},
                                       {HalfSpace{}, facing({0, 0, 0}, Vec3::UnitY())},
                                       {HalfSpace{}, facing({0, 3, 0}, -Vec3::UnitY())}};
  const WallSurface surface = wall_surface(walls, {{-0.5, -0.5, -0.5}, {2.5, 3.5, 4.0}}, around);
  REQUIRE(surface.faces.size() == 5);
  const double areas[] = {6.0, 12.0, 12.0, 8.0, 8.0};
  for (const WallFace& face : surface.faces) {
    const Vec3 area = area_vector(face.corners);
    CHECK(area.norm() == Approx(areas[face.wall]).epsilon(1e-9));
    // Towards the middle of the box: seen from there the corners turn counter-clockwise.
    CHECK(area.dot(Vec3(1.0, 1.5, 2.0) - face.corners[0]) > 0.0);
    for (const Vec3& normal : face.normals) CHECK(normal.dot(area.normalized()) == Approx(1.0));
  }
  CHECK(surface.edges.size() == 12);
}

TEST_CASE("A drum on a floor shows its mantle and a round floor") {
  const std::vector<PlacedShape> walls{{HalfSpace{}, facing({0, 0, 1}, Vec3::UnitZ())},
                                       {Cylinder{2.0, Cylinder::Solid::outside}, Pose{}}};
  const WallSurface surface = wall_surface(walls, {{-3, -3, 0}, {3, 3, 5}}, around);
  double floor = 0.0, mantle = 0.0;
  for (const WallFace& face : surface.faces) (face.wall == 0 ? floor : mantle) += area_vector(face.corners).norm();
  // A polygon about the circle is larger by π²/(3 around²): 0.04 %.
  CHECK(floor == Approx(4.0 * std::numbers::pi).epsilon(5e-4));
  CHECK(mantle == Approx(4.0 * std::numbers::pi * 4.0).epsilon(5e-4));
}

TEST_CASE("A wall beyond the box, a rod and a particle bound nothing") {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  CHECK(wall_surface({{HalfSpace{}, facing({0, 0, -2}, Vec3::UnitZ())}}, box, around).faces.empty());
  CHECK(wall_surface({{Cylinder{0.5, Cylinder::Solid::inside}, Pose{}}}, box, around).faces.empty());
}

TEST_CASE("A spherical container shows its whole inside") {
  const WallSurface surface = wall_surface({{SphereContainer{1.0}, Pose{}}}, {{-2, -2, -2}, {2, 2, 2}}, 24);
  double area = 0.0;
  for (const WallFace& face : surface.faces) area += area_vector(face.corners).norm();
  CHECK(area == Approx(4.0 * std::numbers::pi).epsilon(0.02));  // planes about the sphere: larger by some 1/24²·8
  CHECK(area > 4.0 * std::numbers::pi);
}
