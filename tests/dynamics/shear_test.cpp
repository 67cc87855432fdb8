// Boxes whose images move: shear without walls.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "dynamics/neighbours.hpp"
#include "dynamics/scenes.hpp"
#include "osculate/core/error.hpp"
#include "osculate/dynamics/measures.hpp"
#include "osculate/geometry/common_normal.hpp"

using namespace osculate;

namespace {

constexpr Eigen::Index x = 0, y = 1, z = 2;

PeriodicBox sheared_box(double offset) {
  return {.origin = {0.01, -0.02, 0.03},
          .length = {0.05, 0.04, 0.06},
          .shear = BoxShear{.flow = x, .gradient = z, .rate = 7.0, .offset = offset}};
}

Vec3 random_vector(double size, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-size, size);
  const double a = uniform(random), b = uniform(random), c = uniform(random);
  return {a, b, c};
}

/// Ellipsoids and boxes in a flow along x across z, moved by `shift` against the box.
Setup sheared_gas(const LawChoice& law, double time_step, double rate, const Vec3& shift = Vec3::Zero()) {
  Setup setup = one_material(law, time_step);
  setup.shapes = {candy(), box()};
  constexpr double spacing = 9.5e-3;
  constexpr int per_edge = 4;
  setup.box.length = Vec3::Constant(per_edge * spacing);
  setup.box.shear = BoxShear{.flow = x, .gradient = z, .rate = rate};
  std::mt19937_64 random(5);
  for (int k = 0; k < per_edge; ++k)
    for (int j = 0; j < per_edge; ++j)
      for (int i = 0; i < per_edge; ++i) {
        const Vec3 place = spacing * Vec3(i, j, k);
        BodyStart body = at((i + j + k) % 2, place + shift, random_orientation(random));
        body.velocity = random_vector(0.3, random) + rate * place.z() * Vec3::UnitX();
        setup.bodies.push_back(body);
      }
  return setup;
}

}  // namespace

TEST_CASE("Every image of a point in a sheared box is wrapped to the same point, with the velocity of its image") {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const PeriodicBox box = at_time(sheared_box(0.013), 0.37 * trial);
    const Vec3 point = random_vector(0.2, random), inside = wrapped(box, point);
    REQUIRE(((inside - box.origin).array() >= 0.0).all());
    REQUIRE(((inside - box.origin - box.length).array() < 0.0).all());
    for (const Vec3& image : near_images(box, inside)) {
      REQUIRE((wrapped(box, image) - inside + nearest_image_shift(box, wrapped(box, image) - inside)).norm() < 1e-15);
      const double boxes_up = std::round((image - inside).z() / box.length.z());
      REQUIRE((image_velocity(box, image - inside) - Vec3(boxes_up * 7.0 * 0.06, 0, 0)).norm() < 1e-14);
    }
  }
}

TEST_CASE("Images move with the velocity that they are said to have") {
  const PeriodicBox start = sheared_box(0.013);
  const double t = 0.4, dt = 1e-6;
  const auto image = [&](double when) { return near_images(at_time(start, when), Vec3(0.03, 0.0, 0.05)).back(); };
  const Vec3 rate = (image(t + dt) - image(t - dt)) / (2.0 * dt);
  const Vec3 shift = image(t) - Vec3(0.03, 0.0, 0.05);
  REQUIRE(shift.z() > 0.05);
  CHECK((rate - image_velocity(start, shift)).norm() < 1e-8);
}

TEST_CASE("The grid finds neighbours through the moved faces that an exhaustive search finds") {
  std::mt19937_64 random(2);
  const double offset = GENERATE(0.0, 0.011, -0.024, 0.0249);
  const double largest = GENERATE(5e-3, 9e-3);
  const PeriodicBox box = sheared_box(offset);
  std::vector<Ball> balls;
  std::uniform_real_distribution<double> size(0.0, 1.0);
  for (int i = 0; i < 200; ++i)
    balls.push_back({.centre = 2.0 * random_vector(0.05, random), .radius = largest * std::pow(0.05, size(random))});
  std::vector<BodyPair> expected;
  for (std::int32_t i = 0; i < 200; ++i)
    for (std::int32_t j = i + 1; j < 200; ++j) {
      const auto &one = balls[static_cast<std::size_t>(i)], &two = balls[static_cast<std::size_t>(j)];
      double nearest = 1.0;
      for (const Vec3& image : near_images(box, wrapped(box, two.centre)))
        nearest = std::min(nearest, (image - wrapped(box, one.centre)).norm());
      if (nearest <= one.radius + two.radius) expected.push_back({i, j});
    }
  REQUIRE(expected.size() > 20);
  std::vector<BodyPair> pairs = touching_balls(balls, box);
  std::sort(pairs.begin(), pairs.end());
  CHECK(pairs == expected);
}

TEST_CASE("Two particles meet through a moving face as they would without it") {
  // The upper one's image, one box down, is a body of its own in a space that does not repeat.
  const LawChoice law = damped_frictional_law();
  Setup through = one_material(law, 2e-6);
  through.shapes = {candy(), Ellipsoid{{2e-3, 3e-3, 4e-3}}};
  through.box.length = {0.04, 0.05, 0.06};
  through.box.shear = BoxShear{.flow = x, .gradient = z, .rate = 9.0, .offset = 0.011};
  std::mt19937_64 random(9);
  const Quat turn_1 = random_orientation(random), turn_2 = random_orientation(random);
  BodyStart lower = at(0, {0.02, 0.02, 3e-4}, turn_1), image = at(1, {0.0195, 0.0204, -7e-3}, turn_2);
  lower.velocity = {0.1, 0.0, -0.7};  // out of the box
  lower.angular_velocity = {30.0, 0.0, 50.0};
  image.velocity = {-0.2, 0.1, 0.5};
  Setup plain = through;
  plain.box = {};
  plain.bodies = {lower, image};
  BodyStart upper = image;
  const Vec3 up(0.011, 0.0, 0.06);
  upper.pose.position += up;
  upper.velocity += image_velocity(through.box, up);
  through.bodies = {lower, upper};

  Simulation one(plain), two(through);
  bool met = false;
  std::uint64_t crossed_in_contact = 0;
  for (int i = 0; i < 400; ++i) {
    one.advance(10);
    two.advance(10);
    met = met || one.counts().contacts > 0;
    REQUIRE(one.counts().contacts == two.counts().contacts);
    if (two.counts().contacts > 0 && two.bodies().position[0].z() > 0.03) ++crossed_in_contact;
  }
  REQUIRE(met);
  CHECK(crossed_in_contact > 0);
  CHECK(one.counts().contacts == 0);
  for (const std::size_t body : {0U, 1U}) {
    const Vec3 apart = two.bodies().position[body] - one.bodies().position[body];
    const Vec3 back = nearest_image_shift(two.box(), apart);
    CHECK((apart + back).norm() < 1e-12);
    const Vec3 faster = two.bodies().velocity[body] - one.bodies().velocity[body];
    CHECK((faster + image_velocity(two.box(), back)).norm() < 1e-10);
    CHECK((two.bodies().angular_velocity(body) - one.bodies().angular_velocity(body)).norm() < 1e-7);
  }
  CHECK(two.energy().friction_loss == Approx(one.energy().friction_loss).epsilon(1e-9));
  CHECK(std::fabs(two.energy().driven_work) > 1e-3 * two.energy().lost());
}

TEST_CASE("Where the box begins does not matter to a sheared gas") {
  Simulation here(sheared_gas(damped_frictional_law(), 1e-5, 20.0));
  const Vec3 shift(0.0123, -0.077, 0.029);
  Simulation there(sheared_gas(damped_frictional_law(), 1e-5, 20.0, shift));
  here.advance(1200);
  there.advance(1200);
  REQUIRE(here.energy().lost() > 0.02 * here.energy().mechanical());
  int other_image = 0;
  for (std::size_t i = 0; i < here.bodies().size(); ++i) {
    const Vec3 apart = there.bodies().position[i] - here.bodies().position[i] - shift;
    const Vec3 back = nearest_image_shift(here.box(), apart);
    other_image += back.isZero(1e-6) ? 0 : 1;
    REQUIRE((apart + back).norm() < 1e-7);  // a chaotic gas
    const Vec3 faster = there.bodies().velocity[i] - here.bodies().velocity[i] + image_velocity(here.box(), back);
    CHECK(faster.norm() < 1e-5);
  }
  CHECK(other_image > 10);
}

TEST_CASE("The moving images' work is in the ledger, and the stress times the shear is what the particles get") {
  constexpr double rate = 60.0, dt = 5e-6;
  Simulation simulation(sheared_gas(damped_frictional_law(), dt, rate));
  const double before = simulation.energy().balance(), volume = simulation.setup().box.length.prod();
  // Energies against the flow, and what they were lost to: the power of the stress feeds them.
  const auto fed = [&] {
    const EnergyLedger energy = simulation.energy();
    return -0.5 * volume * stress(simulation, volume).streaming.trace() + energy.rotational + energy.stored_normal +
           energy.stored_tangential + energy.lost() - energy.curvature_gain;
  };
  const double at_first = fed();
  double work = 0.0;
  constexpr int every = 4;
  for (int i = 0; i < 6000; ++i) {
    simulation.advance(every);
    const Stress now = stress(simulation, volume);
    work += every * dt * rate * volume * (now.contact + now.streaming)(x, z);
  }
  const EnergyLedger energy = simulation.energy();
  CAPTURE(energy.driven_work, work, energy.lost(), energy.kinetic);
  CHECK(energy.lost() > 0.2 * work);
  CHECK(std::fabs(energy.balance() - before) < 2e-3 * energy.lost());
  CHECK(fed() - at_first == Approx(work).epsilon(0.01));
}

TEST_CASE("No contact is missed while the flow carries particles past each other") {
  Simulation simulation(sheared_gas(damped_frictional_law(), 1e-5, 80.0));
  const Bodies& bodies = simulation.bodies();
  const auto shape = [&](std::size_t i) {
    return simulation.setup().shapes[static_cast<std::size_t>(bodies.shape[i])];
  };
  std::uint64_t seen = 0;
  for (int look = 0; look < 60; ++look) {
    simulation.advance(37);
    std::uint64_t touching = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (std::size_t j = i + 1; j < bodies.size(); ++j) {
        const Vec3 apart = bodies.position[j] - bodies.position[i];
        const Vec3 shift = nearest_image_shift(simulation.box(), apart);
        if ((apart + shift).norm() > 1.2e-2) continue;
        Pose other = bodies.pose(j);
        other.position += shift;
        touching += common_normal(shape(i), bodies.pose(i), shape(j), other).overlap > 0.0 ? 1 : 0;
      }
    REQUIRE(simulation.counts().contacts == touching);
    seen += touching;
  }
  CHECK(seen > 20);
  CHECK(simulation.counts().rebuilds > 10);
  CHECK(simulation.counts().rebuilds < 60 * 37 / 4);
}

TEST_CASE("A sheared box gives the same bits with any number of threads and after a restart") {
  const auto same = [](const State& a, const State& b) {
    return std::equal(a.arrays.begin(), a.arrays.end(), b.arrays.begin(), b.arrays.end(),
                      [](const StateArray& one, const StateArray& two) { return one.values == two.values; });
  };
  Setup setup = sheared_gas(damped_frictional_law(), 1e-5, 20.0);
  Simulation whole(setup);
  whole.advance(1111);
  const State state = whole.state();
  whole.advance(900);
  setup.threads = 3;
  Simulation again(setup, state);
  CHECK(same(again.state(), state));
  CHECK(again.box().shear->offset != 0.0);
  again.advance(900);
  CHECK(same(again.state(), whole.state()));
}

TEST_CASE("A shear that makes no sense is refused") {
  Setup setup = sheared_gas(elastic_law(), 1e-5, 20.0);
  setup.box.shear->gradient = x;
  CHECK_THROWS_WITH(validate(setup), Catch::Matchers::Contains("two different axes"));
  setup.box.shear->gradient = y;
  setup.box.length[1] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(validate(setup), Catch::Matchers::Contains("axes that repeat"));
  setup = sheared_gas(elastic_law(), 1e-5, 20.0);
  setup.shapes.emplace_back(HalfSpace{});
  setup.bodies.push_back(wall(2, {0, -1, 0}, Vec3::UnitY()));
  CHECK_THROWS_WITH(validate(setup), Catch::Matchers::Contains("another driven body"));
}
