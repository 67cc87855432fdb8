#include "osculate/dynamics/insertion.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "dynamics/scenes.hpp"
#include "osculate/core/error.hpp"
#include "osculate/dynamics/size_distribution.hpp"
#include "osculate/geometry/common_normal.hpp"

using namespace osculate;

TEST_CASE("Particles inserted at random touch neither each other nor the walls") {
  Setup setup = one_material(elastic_law(), 1e-6);
  setup.shapes = {HalfSpace{}, box(), candy()};
  setup.bodies = {wall(0, Vec3::Zero(), Vec3::UnitZ())};
  const bool periodic = GENERATE(false, true);
  if (periodic) setup.box.length = {0.03, 0.03, std::numeric_limits<double>::infinity()};
  const double gap = GENERATE(0.0, 3e-4);
  insert_randomly(setup, {.region = BoxRegion{.lower = {0, 0, 0}, .upper = {0.03, 0.03, 0.03}},
                          .kinds = {{.shape = 1, .material = 0}, {.shape = 2, .material = 0, .weight = 2.0}},
                          .count = 60,
                          .seed = 11,
                          .gap = gap});
  REQUIRE(setup.bodies.size() == 61);
  double least = 1.0;
  for (std::size_t i = 0; i < setup.bodies.size(); ++i)
    for (std::size_t j = i + 1; j < setup.bodies.size(); ++j) {
      const BodyStart &one = setup.bodies[i], &two = setup.bodies[j];
      Pose pose = two.pose;
      if (i > 0) pose.position += nearest_image_shift(setup.box, two.pose.position - one.pose.position);
      const ContactGeometry contact = common_normal(setup.shapes[static_cast<std::size_t>(one.shape)], one.pose,
                                                    setup.shapes[static_cast<std::size_t>(two.shape)], pose);
      least = std::min(least, -contact.overlap);
    }
  CHECK(least > gap);
  CHECK(least < gap + 1e-3);
}

TEST_CASE("The same seed gives the same particles, another one others") {
  Setup first = one_material(elastic_law(), 1e-6);
  first.shapes = {candy()};
  Setup second = first, third = first;
  RandomInsertion insertion{.region = CylinderRegion{.base = {0, 0, 0}, .radius = 0.02, .height = 0.03},
                            .kinds = {{.shape = 0, .material = 0}},
                            .count = 40,
                            .seed = 5,
                            .fluctuation = 0.1};
  insert_randomly(first, insertion);
  insert_randomly(second, insertion);
  insertion.seed = 6;
  insert_randomly(third, insertion);
  int differ = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    CHECK(first.bodies[i].pose.position == second.bodies[i].pose.position);
    CHECK(first.bodies[i].velocity == second.bodies[i].velocity);
    differ += first.bodies[i].pose.position != third.bodies[i].pose.position ? 1 : 0;
  }
  CHECK(differ == 40);
}

TEST_CASE("Particles that find no room are an error and leave the setup as it was") {
  Setup setup = one_material(elastic_law(), 1e-6);
  setup.shapes = {Sphere{5e-3}};
  const RandomInsertion insertion{.region = SphereRegion{.centre = {0, 0, 0}, .radius = 0.01},
                                  .kinds = {{.shape = 0, .material = 0}},
                                  .count = 100,
                                  .seed = 1,
                                  .tries = 200};
  CHECK_THROWS_WITH(insert_randomly(setup, insertion), Catch::Matchers::Contains("of 100 particles found a place"));
  CHECK(setup.bodies.empty());
}

TEST_CASE("A lattice fills its region with whole cells") {
  const BoxRegion box{.lower = {0, 0, 0}, .upper = {0.03, 0.02, 0.01}};
  const std::vector<Vec3> points = lattice(box, 0.01);
  REQUIRE(points.size() == 6);
  CHECK((points[0] - Vec3(5e-3, 5e-3, 5e-3)).norm() < 1e-15);
  for (const Vec3& point : lattice(SphereRegion{.centre = {1, 2, 3}, .radius = 0.5}, 0.1))
    CHECK((point - Vec3(1, 2, 3)).norm() <= 0.45 + 1e-9);
}

TEST_CASE("Size classes have the moments of their distribution") {
  constexpr int count = 20000;
  const auto mean = [](const std::vector<double>& sizes) {
    double sum = 0.0;
    for (const double size : sizes) sum += size;
    return sum / count;
  };
  CHECK(mean(size_classes(UniformSizes{.least = 1.0, .most = 3.0}, count)) == Approx(2.0));
  CHECK(mean(size_classes(LogNormalSizes{.median = 2.0, .sigma = 0.4}, count)) ==
        Approx(2.0 * std::exp(0.08)).epsilon(1e-3));
  CHECK(mean(size_classes(WeibullSizes{.scale = 2.0, .modulus = 3.0}, count)) ==
        Approx(2.0 * std::tgamma(4.0 / 3.0)).epsilon(1e-3));
}

TEST_CASE("A scaled shape has the volume of its scale") {
  for (const Shape& shape : {Shape(box()), Shape(candy()), Shape(Sphere{2e-3})})
    CHECK(mass_properties(scaled(shape, 1.7)).volume == Approx(1.7 * 1.7 * 1.7 * mass_properties(shape).volume));
  CHECK_THROWS_AS(scaled(HalfSpace{}, 2.0), InputError);
}
