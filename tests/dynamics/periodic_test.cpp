// Periodic boxes, and the faults that a simulation has to refuse.

#include <catch2/catch.hpp>
#include <limits>

#include "dynamics/scenes.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;

namespace {

/// A gas of particles in a box that repeats in all directions.
Setup periodic_gas(const LawChoice& law, double time_step, const Vec3& shift) {
  Setup setup = one_material(law, time_step);
  setup.shapes = {candy(), box()};
  constexpr double spacing = 9.5e-3;
  constexpr int per_edge = 4;
  setup.box.length = Vec3::Constant(per_edge * spacing);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> speed(-0.5, 0.5);
  for (int k = 0; k < per_edge; ++k)
    for (int j = 0; j < per_edge; ++j)
      for (int i = 0; i < per_edge; ++i) {
        BodyStart body = at((i + j + k) % 2, spacing * Vec3(i, j, k) + shift, random_orientation(random));
        const double x = speed(random), y = speed(random), z = speed(random);
        body.velocity = {x, y, z};
        setup.bodies.push_back(body);
      }
  return setup;
}

}  // namespace

TEST_CASE("In a periodic box momentum is conserved and the origin does not matter") {
  Simulation here(periodic_gas(damped_frictional_law(), 1e-5, Vec3::Zero()));
  Simulation there(periodic_gas(damped_frictional_law(), 1e-5, Vec3(0.0123, -0.077, 0.03)));
  const auto momentum = [](const Simulation& simulation) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < simulation.bodies().size(); ++i)
      sum += simulation.bodies().mass[i] * simulation.bodies().velocity[i];
    return sum;
  };
  const Vec3 before = momentum(here);
  here.advance(1500);
  there.advance(1500);
  REQUIRE(here.energy().lost() > 0.05 * here.energy().mechanical());
  CHECK((momentum(here) - before).norm() < 1e-13 * here.bodies().mass[0] * 64.0);
  for (std::size_t i = 0; i < here.bodies().size(); ++i)
    CHECK((here.bodies().velocity[i] - there.bodies().velocity[i]).norm() < 1e-7);  // a chaotic gas: seven collisions
}

TEST_CASE("Gravity along a periodic direction stays in the ledger") {
  Setup setup = periodic_gas(damped_frictional_law(), 5e-6, Vec3::Zero());
  setup.gravity = {0, 0, -9.81};
  Simulation simulation(setup);
  const double before = simulation.energy().balance();
  simulation.advance(20000);
  CHECK(std::fabs(simulation.energy().balance() - before) < 2e-3 * simulation.energy().lost());
}

TEST_CASE("A periodic box too small for its particles is refused") {
  Setup setup = periodic_gas(elastic_law(), 1e-5, Vec3::Zero());
  setup.box.length.y() = 0.015;
  CHECK_THROWS_AS(Simulation(setup), InputError);
}

TEST_CASE("What cannot be simulated is refused with the body's number") {
  using Catch::Matchers::Contains;
  Setup setup = one_material(elastic_law(), 1e-6);
  setup.shapes = {Sphere{1e-3}, HalfSpace{}};
  setup.bodies = {at(0, {0, 0, 0}), at(0, {0, 0, 3e-3})};

  SECTION("an empty scene") {
    setup.bodies.clear();
    CHECK_THROWS_WITH(Simulation(setup), Contains("a free body"));
  }
  SECTION("no mass") {
    setup.materials[0].density = 0.0;
    CHECK_THROWS_WITH(Simulation(setup), Contains("material 0 (glass)") && Contains("density"));
  }
  SECTION("bodies that start overlapping by half a radius") {
    setup.bodies[1].pose.position.z() = 1.5e-3;
    CHECK_THROWS_WITH(Simulation(setup), Contains("bodies 0 and 1 overlap by 0.0005"));
  }
  SECTION("a position that is not finite") {
    setup.bodies[1].pose.position.x() = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(Simulation(setup), Contains("body 1"));
  }
  SECTION("an orientation that is none") {
    setup.bodies[1].pose.orientation = Quat(1, 1, 0, 0);
    CHECK_THROWS_WITH(Simulation(setup), Contains("body 1") && Contains("unit quaternion"));
  }
  SECTION("a free wall") {
    setup.bodies[1].shape = 1;
    CHECK_THROWS_WITH(Simulation(setup), Contains("body 1") && Contains("half-space"));
  }
  SECTION("a speed that crosses a body in one step") {
    setup.bodies[1].velocity = {0, 0, -2000.0};
    Simulation simulation(setup);
    CHECK_THROWS_WITH(simulation.advance(1), Contains("step 1") && Contains("body 1 moved 0.002 m in one step"));
  }
  SECTION("a motion that does not exist") {
    setup.bodies[1].motion = 3;
    CHECK_THROWS_WITH(Simulation(setup), Contains("body 1") && Contains("motion 3"));
  }
  SECTION("materials that have no law between them") {
    setup.materials.push_back(soft_glass());
    setup.bodies[1].material = 1;
    CHECK_THROWS_WITH(Simulation(setup), Contains("interactions"));
  }
  SECTION("a time step of zero") {
    setup.time_step = 0.0;
    CHECK_THROWS_WITH(Simulation(setup), Contains("time step"));
  }
}

TEST_CASE("A number that is not finite stops the run at once") {
  Setup setup = one_material(elastic_law(), 1e-6);
  setup.shapes = {Sphere{1e-3}};
  setup.bodies = {at(0, {0, 0, 0}), at(0, {0, 0, 3e-3})};
  Simulation simulation(setup);
  State state = simulation.state();
  for (StateArray& array : state.arrays)
    if (array.name == "bodies.velocity") std::get<std::vector<double>>(array.values)[4] = std::nan("");
  Simulation broken(setup, state);
  CHECK_THROWS_WITH(broken.advance(1),
                    Catch::Matchers::Contains("body 1 has a position or velocity that is not finite"));
}
