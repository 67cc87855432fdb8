#include "dynamics/pouring.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "dynamics/scenes.hpp"
#include "osculate/core/error.hpp"
#include "osculate/geometry/common_normal.hpp"

using namespace osculate;

namespace {

constexpr double step = 2e-5;

/// An open box into which ellipsoids (two in three) and blocks fall.
Setup filling(const LawChoice& law, double time_step = step) {
  Setup setup = settling(law, {blocky(), candy()}, 1, 0.04, time_step);
  setup.bodies.pop_back();
  setup.pours = {{.region = BoxRegion{.lower = {4e-3, 4e-3, 0.03}, .upper = {0.036, 0.036, 0.04}},
                  .kinds = {{.shape = 1, .material = 0}, {.shape = 2, .material = 0, .weight = 2.0}},
                  .rate = 2000.0,
                  .seed = 3,
                  .velocity = {0.0, 0.0, -0.5},
                  .fluctuation = 0.05}};
  return setup;
}

std::size_t poured_bodies(const Simulation& simulation) {
  return simulation.bodies().size() - simulation.setup().bodies.size();
}

bool same(const State& a, const State& b) {
  REQUIRE(a.arrays.size() == b.arrays.size());
  for (std::size_t i = 0; i < a.arrays.size(); ++i) {
    INFO(a.arrays[i].name);
    if (a.arrays[i].values != b.arrays[i].values) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("A pour brings in particles at its rate, from its beginning to its end") {
  Setup setup = filling(damped_frictional_law());
  setup.pours[0].begin = 0.01;
  setup.pours[0].end = 0.03;
  Simulation simulation(setup);
  CHECK(poured_bodies(simulation) == 0);
  simulation.advance(500);  // to the beginning
  CHECK(poured_bodies(simulation) == 0);
  simulation.advance(501);  // one look after 20 of 40 are due
  CHECK(poured_bodies(simulation) == 20);
  simulation.advance(1000);
  CHECK(poured_bodies(simulation) == 40);
  CHECK(simulation.poured()[0].particles == 40);
  double mass = 0.0;
  for (std::size_t i = setup.bodies.size(); i < simulation.bodies().size(); ++i) mass += simulation.bodies().mass[i];
  CHECK(simulation.poured()[0].mass == Approx(mass).epsilon(1e-14));
}

TEST_CASE("A pour measured by mass keeps to it, and to the most particles it may bring") {
  Setup setup = filling(damped_frictional_law());
  setup.pours[0].measure = Pour::Measure::mass;
  setup.pours[0].rate = 0.3;
  Simulation simulation(setup);
  simulation.advance(2001);
  const Poured& poured = simulation.poured()[0];
  double heaviest = 0.0;
  for (const double mass : simulation.bodies().mass) heaviest = std::max(heaviest, mass);
  CHECK(poured.mass <= 0.3 * 0.04);
  CHECK(poured.mass > 0.3 * 0.04 - heaviest);
  setup.pours[0].most = 7;
  Simulation few(setup);
  few.advance(2001);
  CHECK(poured_bodies(few) == 7);
}

TEST_CASE("Kinds come in by their shares, with the velocity and the spread asked for") {
  Setup setup = filling(elastic_law());
  setup.pours[0].rate = 1e4;
  std::vector<Vec3> velocities;
  std::size_t blocks = 0;
  const World world = make_world(setup);
  Poured poured;
  const Bodies none;
  for (std::uint64_t look = 1; velocities.size() < 3000; ++look)
    for (const BodyStart& body : poured_now(world, none, setup.pours[0], look * steps_between_pours, poured)) {
      velocities.push_back(body.velocity);
      if (body.shape == 1) ++blocks;
    }
  Vec3 mean = Vec3::Zero(), square = Vec3::Zero();
  const auto count = static_cast<double>(velocities.size());
  for (const Vec3& v : velocities) mean += v / count;
  for (const Vec3& v : velocities) square += (v - mean).cwiseAbs2() / count;
  // Four standard errors of a share, a mean and a variance.
  CHECK(std::fabs(static_cast<double>(blocks) / count - 1.0 / 3.0) < 4.0 * std::sqrt(2.0 / 9.0 / count));
  CHECK((mean - setup.pours[0].velocity).cwiseAbs().maxCoeff() < 4.0 * 0.05 / std::sqrt(count));
  CHECK((square / (0.05 * 0.05) - Vec3::Ones()).cwiseAbs().maxCoeff() < 4.0 * std::sqrt(2.0 / count));
}

TEST_CASE("What comes in keeps its gap to everything that is there") {
  Setup setup = filling(elastic_law());
  setup.pours[0].gap = 2e-4;
  const World world = make_world(setup);
  Bodies bodies = make_bodies(world);
  Poured poured;
  double least = 1.0;
  for (std::uint64_t look = 1; look <= 60; ++look)
    for (const BodyStart& body : poured_now(world, bodies, setup.pours[0], look * steps_between_pours, poured)) {
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        const ContactGeometry contact =
            common_normal(setup.shapes[static_cast<std::size_t>(body.shape)], body.pose,
                          setup.shapes[static_cast<std::size_t>(bodies.shape[i])], bodies.pose(i));
        least = std::min(least, -contact.overlap);
      }
      append_body(world, body, "test", bodies);
    }
  CHECK(poured.particles > 15);
  CHECK(least > 2e-4);
  CHECK(least < 1e-3);
}

TEST_CASE("A particle that finds no place waits for it, and comes in when there is one") {
  Setup setup = filling(damped_frictional_law());
  setup.pours[0].velocity = Vec3::Zero();
  setup.pours[0].fluctuation = 0.0;
  setup.pours[0].end = 0.02;
  setup.pours[0].rate = 1e4;
  Simulation simulation(setup);
  simulation.advance(1001);
  CHECK(due(setup.pours[0], simulation.time()) == 200);
  const std::size_t at_first = poured_bodies(simulation);
  CHECK(at_first > 5);
  CHECK(at_first < 200);
  simulation.advance(2000);  // those that came have fallen
  CHECK(poured_bodies(simulation) > at_first);
}

TEST_CASE("What particles bring with them is in the ledger") {
  Simulation simulation(filling(damped_frictional_law(), 2.5e-6));
  const double before = simulation.energy().balance();
  simulation.advance(24000);
  const EnergyLedger energy = simulation.energy();
  CHECK(poured_bodies(simulation) > 80);
  CHECK(energy.poured > 0.0);
  CHECK(energy.lost() > 0.1 * energy.poured);
  CHECK(std::fabs(energy.balance() - before) < 1e-3 * energy.lost());
}

TEST_CASE("Pouring gives the same bits with any number of threads and after a restart") {
  Setup setup = filling(damped_frictional_law());
  setup.pours[0].rate = 4000.0;
  Simulation whole(setup);
  whole.advance(1234);
  const State state = whole.state();
  REQUIRE(poured_bodies(whole) > 20);
  whole.advance(2500);
  REQUIRE(whole.counts().contacts > 15);
  setup.threads = 3;
  Simulation again(setup, state);
  CHECK(same(again.state(), state));
  again.advance(2500);
  CHECK(same(again.state(), whole.state()));
  Simulation threaded(setup);
  threaded.advance(3734);
  CHECK(same(threaded.state(), whole.state()));
  setup.pours[0].seed = 4;
  Simulation other(setup);
  other.advance(1234);
  CHECK(other.bodies().position.back() != threaded.bodies().position[other.bodies().size() - 1]);
}

TEST_CASE("A pour that makes no sense is refused with its number") {
  const auto refused = [](const auto& change, const std::string& why) {
    Setup setup = filling(elastic_law());
    change(setup.pours[0]);
    CHECK_THROWS_WITH(validate(setup), Catch::Matchers::Contains("pour 0") && Catch::Matchers::Contains(why));
  };
  refused([](Pour& pour) { pour.rate = 0.0; }, "a rate of 0");
  refused([](Pour& pour) { pour.kinds[0].shape = 0; }, "a wall");
  refused([](Pour& pour) { pour.kinds[0].material = 5; }, "material 5");
  refused([](Pour& pour) { pour.kinds.clear(); }, "no kinds");
  refused([](Pour& pour) { pour.end = 0.0; }, "an end after");
  refused([](Pour& pour) { pour.region = SphereRegion{.centre = {0, 0, 0}, .radius = 0.0}; }, "without volume");
  Setup other = filling(elastic_law());
  Simulation simulation(filling(elastic_law()));
  simulation.advance(200);
  other.pours.clear();
  other.bodies.push_back(at(1, {0.02, 0.02, 0.02}));
  CHECK_THROWS_AS(Simulation(other, simulation.state()), InputError);
}
