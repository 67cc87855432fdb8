#include "osculate/shapes/shape.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "osculate/core/error.hpp"
#include "shapes/sample_shapes.hpp"

using namespace osculate;

TEST_CASE("Every particle answers every question consistently") {
  std::mt19937 random(1);
  for (const Shape& shape : samples::particles()) {
    CAPTURE(kind(shape));
    CHECK(is_particle(shape));
    CHECK_NOTHROW(validate(shape));
    const double radius = bounding_radius(shape);
    const OrientedBox box = oriented_box(shape);
    for (int i = 0; i < 50; ++i) {
      const Vec3 x = support_point(shape, samples::random_direction(random));
      CHECK(gauge(shape, x).value == Approx(1.0).epsilon(1e-12));
      CHECK(x.norm() <= radius);
      CHECK(((x - box.centre).cwiseAbs() - box.half_extents).maxCoeff() <= 1e-12 * radius);
    }
    const MassProperties mass = mass_properties(shape);
    CHECK(mass.volume > 0.0);
    CHECK(mass.volume < 8.0 * box.half_extents.prod());
    CHECK(volume_equivalent_radius(mass.volume) <= radius * (1.0 + 1e-6));
  }
}

TEST_CASE("Walls have no volume and no bound, and say so") {
  for (const Shape& wall :
       {Shape{HalfSpace{}}, Shape{Cylinder{1.0, Cylinder::Solid::inside}}, Shape{SphereContainer{1.0}}}) {
    CHECK_FALSE(is_particle(wall));
    CHECK(std::isinf(bounding_radius(wall)));
    CHECK_THROWS_WITH(mass_properties(wall), Catch::Contains(std::string(kind(wall))));
    CHECK_THROWS_AS(oriented_box(wall), InputError);
    CHECK_THROWS_AS(support_point(wall, Vec3::UnitX()), InputError);
    CHECK_THROWS_AS(gauge(wall, Vec3::UnitX()), InputError);
  }
}

TEST_CASE("Kinds have the names that files use") {
  CHECK(kind(Superquadric{Vec3::Ones(), {}}) == "superquadric");
  CHECK(kind(Ellipsoid{Vec3::Ones()}) == "ellipsoid");
  CHECK(kind(Sphere{1.0}) == "sphere");
  CHECK(kind(samples::potential_stone()) == "potential particle");
  CHECK(kind(HalfSpace{}) == "half-space");
  CHECK(kind(Cylinder{}) == "cylinder");
  CHECK(kind(SphereContainer{}) == "sphere container");
}

TEST_CASE("The volume-equivalent radius of a sphere is its radius") {
  CHECK(volume_equivalent_radius(4.0 / 3.0 * std::numbers::pi * 8e-6) == Approx(0.02).epsilon(1e-15));
}
