#include "osculate/shapes/walls.hpp"

#include <catch2/catch.hpp>

#include "osculate/core/error.hpp"

using namespace osculate;

TEST_CASE("A wall's distance is positive where particles live, and its normal points to them") {
  CHECK(signed_distance(HalfSpace{}, Vec3(3, 4, -0.5)).value == -0.5);
  CHECK(signed_distance(HalfSpace{}, Vec3(3, 4, 5)).normal == Vec3(0, 0, 1));

  const Cylinder rod{2.0, Cylinder::Solid::inside}, drum{2.0, Cylinder::Solid::outside};
  const Vec3 x(3.0, 4.0, 7.0);
  CHECK(signed_distance(rod, x).value == Approx(3.0));
  CHECK(signed_distance(drum, x).value == Approx(-3.0));
  CHECK((signed_distance(rod, x).normal - Vec3(0.6, 0.8, 0.0)).norm() < 1e-15);
  CHECK((signed_distance(drum, x).normal + Vec3(0.6, 0.8, 0.0)).norm() < 1e-15);

  const SphereContainer bowl{10.0};
  CHECK(signed_distance(bowl, Vec3(0, 3, 4)).value == Approx(5.0));
  CHECK((signed_distance(bowl, Vec3(0, 3, 4)).normal - Vec3(0, -0.6, -0.8)).norm() < 1e-15);
}

TEST_CASE("On the axis of a drum and in the centre of a container the direction is a fixed one") {
  CHECK(signed_distance(Cylinder{2.0, Cylinder::Solid::outside}, Vec3(0, 0, 5)).value == 2.0);
  CHECK(signed_distance(Cylinder{2.0, Cylinder::Solid::outside}, Vec3(0, 0, 5)).normal == Vec3(1, 0, 0));
  CHECK(signed_distance(SphereContainer{2.0}, Vec3::Zero()).normal == Vec3(1, 0, 0));
}

TEST_CASE("Walls without a radius are refused") {
  CHECK_NOTHROW(validate(HalfSpace{}));
  CHECK_THROWS_AS(validate(Cylinder{0.0, Cylinder::Solid::inside}), InputError);
  CHECK_THROWS_AS(validate(SphereContainer{-1.0}), InputError);
}
