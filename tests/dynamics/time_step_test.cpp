#include "osculate/dynamics/time_step.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "dynamics/scenes.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;

TEST_CASE("The shortest impact of two spheres is that of Hertz") {
  // 3.18 mm glass spheres at 1 m/s: 9.51 µs is that of the lecture notes' worked example.             [Wassgren06]
  Setup setup;
  setup.materials = {{.name = "glass", .elastic = {.youngs_modulus = 71e9, .poissons_ratio = 0.22}, .density = 2500.0}};
  setup.interactions.push_back(
      {0, 0, make_contact_law(elastic_law(), setup.materials[0].elastic, setup.materials[0].elastic)});
  setup.shapes = {Sphere{1.59e-3}};
  setup.bodies = {at(0, {0, 0, 0}), at(0, {0, 0, 1})};
  const TimeStepLimits limits = time_step_limits(setup, 1.0);
  CHECK(limits.contact_duration == Approx(9.51e-6).epsilon(0.01));
  CHECK(limits.shortest == "shape 0, glass on shape 0, glass");
  CHECK(limits.recommended < limits.largest);
  CHECK_THROWS_AS(time_step_limits(setup, 0.0), InputError);
}

TEST_CASE("A box makes shorter impacts than a sphere of its volume") {
  Setup setup = one_material(damped_frictional_law(), 1.0);
  const double radius = volume_equivalent_radius(mass_properties(box()).volume);
  setup.shapes = {box(), Sphere{radius}, HalfSpace{}};
  setup.bodies = {at(1, {0, 0, 0}), wall(2, {0, 0, -1}, Vec3::UnitZ())};
  const TimeStepLimits sphere = time_step_limits(setup, 0.5);
  setup.bodies[0] = at(0, {0, 0, 0});
  const TimeStepLimits flat = time_step_limits(setup, 0.5);
  CHECK(flat.contact_duration < 0.7 * sphere.contact_duration);
  CHECK(flat.contact_duration > 0.1 * sphere.contact_duration);
  CHECK(flat.rayleigh_time == Approx(sphere.rayleigh_time * 2e-3 / radius));
}

TEST_CASE("At the recommended step a fast impact takes the promised number of steps") {
  Setup setup = one_material(elastic_law(), 1.0);
  setup.shapes = {candy(), HalfSpace{}};
  BodyStart body = at(0, {0, 0, 1.9e-3});
  body.velocity = {0, 0, -0.5};
  setup.bodies = {body, wall(1, {0, 0, 0}, Vec3::UnitZ())};
  setup.time_step = time_step_limits(setup, 0.5).contact_duration / steps_per_contact;
  Simulation simulation(setup);
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    simulation.advance(1);
    touching += simulation.counts().contacts > 0 ? 1 : 0;
  }
  CHECK(touching >= 40);
  CHECK(touching < 100);
}
