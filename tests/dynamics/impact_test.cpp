// Two bodies that hit each other, and a wall.

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "dynamics/scenes.hpp"
#include "osculate/geometry/common_normal.hpp"

using namespace osculate;

namespace {

constexpr double glass_modulus = 71e9;

/// Glass, so that a slow impact is a small one.
Setup glass_pair(const LawChoice& law, const Shape& shape_1, const Shape& shape_2, double time_step) {
  Setup setup;
  setup.materials = {
      {.name = "glass", .elastic = {.youngs_modulus = glass_modulus, .poissons_ratio = 0.22}, .density = 2500.0}};
  const ElasticMaterial& elastic = setup.materials[0].elastic;
  setup.interactions.push_back({0, 0, make_contact_law(law, elastic, elastic)});
  setup.shapes = {shape_1, shape_2};
  setup.time_step = time_step;
  return setup;
}

struct Momentum {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
};
Momentum momentum_of(const Bodies& bodies) {
  Momentum sum;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vec3 linear = bodies.mass[i] * bodies.velocity[i];
    sum.linear += linear;
    sum.angular += bodies.position[i].cross(linear) + bodies.orientation[i] * bodies.angular_momentum[i];
  }
  return sum;
}

/// Body 2 flies at body 1, off its centre, both turned and turning.
Setup oblique(const LawChoice& law, const Shape& shape, double speed, double time_step) {
  Setup setup = glass_pair(law, shape, shape, time_step);
  const double reach = bounding_radius(shape);
  BodyStart one = at(0, {0.1 * reach, 0.0, 0.0}, Quat(0.9, 0.2, -0.3, 0.1).normalized());
  BodyStart two = at(1, {-0.2 * reach, 0.3 * reach, 2.0 * reach}, Quat(0.4, -0.5, 0.2, 0.7).normalized());
  two.velocity = {0.1 * speed, -0.1 * speed, -speed};
  one.angular_velocity = speed / reach * Vec3(0.2, 0.1, -0.1);
  // Up to a few steps before they touch.
  for (int i = 0; i < 60; ++i) {
    const double gap = -common_normal(shape, one.pose, shape, two.pose).overlap - 3.0 * two.velocity.norm() * time_step;
    two.pose.position += gap * two.velocity.normalized();
  }
  setup.bodies = {one, two};
  return setup;
}

/// The time step of `steps` in the Hertz impact of two such bodies, taken for spheres.
double step_of(const Shape& shape, double speed, int steps) {
  const double radius = 0.5 * volume_equivalent_radius(mass_properties(shape).volume);
  const double mass = 0.5 * 2500.0 * mass_properties(shape).volume;
  const double modulus = 0.5 * glass_modulus / (1.0 - 0.22 * 0.22);
  const double stiffness = 4.0 / 3.0 * modulus * std::sqrt(radius);
  const double depth = std::pow(1.25 * mass * speed * speed / stiffness, 0.4);
  return 2.9432 * depth / speed / steps;
}

/// Runs until the bodies have touched and parted.
void collide(Simulation& simulation) {
  constexpr int most = 10'000;
  bool touched = false;
  for (int i = 0; i < most; ++i) {
    simulation.advance(1);
    const bool touching = simulation.counts().contacts > 0;
    touched = touched || touching;
    if (touched && !touching) return;
  }
  FAIL("no impact");
}

}  // namespace

TEST_CASE("An oblique impact conserves linear and angular momentum, with friction and damping too") {
  const Shape shape = GENERATE(Shape(blocky()), Shape(box()), Shape(candy()));
  const LawChoice law = GENERATE(elastic_law(), damped_frictional_law());
  constexpr double speed = 0.1;
  Simulation simulation(oblique(law, shape, speed, step_of(shape, speed, 50)));
  const Momentum before = momentum_of(simulation.bodies());
  collide(simulation);
  const Momentum after = momentum_of(simulation.bodies());
  CHECK((after.linear - before.linear).norm() < 1e-12 * before.linear.norm());
  CHECK((after.angular - before.angular).norm() < 1e-12 * before.linear.norm() * bounding_radius(shape));
  CHECK(simulation.bodies().velocity[0].norm() > 0.1 * speed);
}

TEST_CASE("What an impact of curved bodies fails to give back is what their springs gained by curvature") {
  // Fast and deep, along rounded edges.
  constexpr double speed = 2.0;
  Simulation simulation(oblique(elastic_law(), box(), speed, step_of(box(), speed, 2000)));
  const EnergyLedger before = simulation.energy();
  constexpr int most = 100'000;
  for (int i = 0; i < most && (i < 10 || simulation.counts().contacts > 0); ++i) simulation.advance(1);
  const EnergyLedger after = simulation.energy();
  REQUIRE(std::fabs(after.mechanical() - before.mechanical()) > 1e-5 * before.mechanical());
  CHECK(std::fabs(after.balance() - before.balance()) < 0.01 * std::fabs(after.curvature_gain));
}

TEST_CASE("An elastic frictionless impact gives back its energy to 1e-6 at 50 steps a contact") {
  // Slow: the force law takes the curvature where the bodies touch at each moment, and that changes while they slide on
  // each other; what it costs falls with the depth of the contact over the radius.
  const Shape shape = GENERATE(Shape(Sphere{2e-3}), Shape(candy()), Shape(blocky()));
  constexpr double speed = 1e-4;
  Simulation simulation(oblique(elastic_law(), shape, speed, step_of(shape, speed, 50)));
  const double before = simulation.energy().mechanical();
  collide(simulation);
  CHECK(std::fabs(simulation.energy().mechanical() / before - 1.0) < 1e-6);
}

TEST_CASE("The motion in an impact converges to second order in the time step") {
  constexpr double speed = 0.05;
  const Shape shape = candy();
  const double step = step_of(shape, speed, 50);
  const auto velocity_after = [&](int refinement) {
    Setup setup = oblique(elastic_law(), shape, speed, step);
    setup.time_step = step / refinement;
    Simulation simulation(setup);
    simulation.advance(static_cast<std::uint64_t>(20 * refinement));
    REQUIRE(simulation.counts().contacts == 1);
    REQUIRE(simulation.bodies().velocity[0].norm() > 0.05 * speed);
    return simulation.bodies().velocity[0];
  };
  const Vec3 reference = velocity_after(64);
  const double coarse = (velocity_after(2) - reference).norm(), fine = (velocity_after(8) - reference).norm();
  CHECK(coarse < 1e-3 * speed);
  CHECK(std::log2(coarse / fine) / 2.0 == Approx(2.0).margin(0.3));
}

TEST_CASE("A sphere bounces off a wall with the restitution that its dashpot promises") {
  for (const double restitution : {0.9, 0.5}) {
    Setup setup =
        glass_pair({{"hertz", {}}, {"tsuji", {{"restitution", restitution}}}}, Sphere{2e-3}, HalfSpace{}, 1e-8);
    setup.motions = {Fixed{}};
    BodyStart ball = at(0, {0, 0, 2.001e-3});
    ball.velocity = {0, 0, -0.5};
    setup.bodies = {ball, wall(1, Vec3::Zero(), Vec3::UnitZ())};
    Simulation simulation(setup);
    collide(simulation);
    CHECK(simulation.bodies().velocity[0].z() / 0.5 == Approx(restitution).epsilon(3e-3));
  }
}

TEST_CASE("A sphere rolls down an incline with 5/7 of what slides") {
  Setup setup = glass_pair({{"hertz", {}}, {"tsuji", {{"restitution", 0.3}}}, {"mindlin", {{"friction", 0.5}}}},
                           Sphere{2e-3}, HalfSpace{}, 2e-7);
  setup.materials[0].elastic.youngs_modulus = 1e8;
  setup.interactions = {
      {0, 0,
       make_contact_law({{"hertz", {}}, {"tsuji", {{"restitution", 0.3}}}, {"mindlin", {{"friction", 0.5}}}},
                        setup.materials[0].elastic, setup.materials[0].elastic)}};
  constexpr double angle = 0.3;
  setup.gravity = 9.81 * Vec3(std::sin(angle), 0.0, -std::cos(angle));
  setup.motions = {Fixed{}};
  setup.time_step = 4e-6;
  setup.bodies = {at(0, {0, 0, 2e-3 - 1e-6}), wall(1, Vec3::Zero(), Vec3::UnitZ())};
  Simulation simulation(setup);
  simulation.advance(10000);
  const double first = simulation.bodies().velocity[0].x();
  simulation.advance(10000);
  const double acceleration = (simulation.bodies().velocity[0].x() - first) / 0.04;
  CHECK(acceleration == Approx(5.0 / 7.0 * 9.81 * std::sin(angle)).epsilon(2e-3));
  CHECK(simulation.bodies().angular_velocity(0).y() * 2e-3 ==
        Approx(simulation.bodies().velocity[0].x()).epsilon(2e-3));
}

TEST_CASE("The work of a driven wall is what the bodies get") {
  // A vibrating floor throws spheres about; side walls keep them.
  Setup setup = settling(damped_frictional_law(), {Sphere{2e-3}}, 3, 6e-3, 2.5e-6);
  setup.motions.push_back(Oscillation{.amplitude = {0, 0, 1e-3}, .frequency = 60.0});
  setup.bodies[0].motion = 1;
  Simulation simulation(setup);
  const double before = simulation.energy().balance();
  simulation.advance(60000);
  const EnergyLedger energy = simulation.energy();
  CHECK(energy.driven_work > 0.2 * energy.lost());
  CHECK(std::fabs(energy.balance() - before) < 2e-3 * energy.lost());
}
