#include "osculate/dynamics/simulation.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "dynamics/scenes.hpp"
#include "osculate/core/error.hpp"
#include "osculate/geometry/common_normal.hpp"

using namespace osculate;

namespace {

bool same(const State& a, const State& b) {
  REQUIRE(a.arrays.size() == b.arrays.size());
  for (std::size_t i = 0; i < a.arrays.size(); ++i) {
    INFO(a.arrays[i].name);
    REQUIRE(a.arrays[i].name == b.arrays[i].name);
    if (a.arrays[i].values != b.arrays[i].values) return false;
  }
  return true;
}

Setup mixed_scene(int threads) {
  Setup setup = settling(damped_frictional_law(), {blocky(), candy(), box()}, 6, 9.5e-3, 2e-5);
  setup.threads = threads;
  return setup;
}

}  // namespace

TEST_CASE("Particles fall into a box and come to rest in it") {
  Simulation simulation(settling(damped_frictional_law(), {blocky(), candy()}, 4, 8e-3, 2e-5));
  simulation.advance(25000);
  const Bodies& bodies = simulation.bodies();
  const EnergyLedger energy = simulation.energy();
  CHECK(energy.kinetic + energy.rotational < 1e-3 * energy.lost());
  for (std::size_t i = 5; i < bodies.size(); ++i) {
    CHECK(bodies.position[i].z() > 1.7e-3);
    CHECK(bodies.position[i].z() < 0.02);
  }
  double weight = 0.0;
  for (std::size_t i = 5; i < bodies.size(); ++i) weight += 9.81 * bodies.mass[i];
  // The floor carries what is at rest; friction at the side walls may take a part.
  CHECK(-bodies.force[0].z() > 0.5 * weight);
  CHECK(-bodies.force[0].z() < 1.05 * weight);
}

TEST_CASE("The energy of a damped frictional scene is accounted for to 1e-3 of what was lost") {
  // 80 steps in a Hertz impact at the speed of the fall; the error falls with the square of the step.
  Simulation simulation(settling(damped_frictional_law(), {blocky(), candy()}, 4, 8e-3, 2.5e-6));
  const double before = simulation.energy().balance();
  simulation.advance(40000);
  const EnergyLedger energy = simulation.energy();
  CAPTURE(energy.kinetic, energy.rotational, energy.gravity, energy.stored_normal, energy.stored_tangential,
          energy.viscous_loss, energy.friction_loss, energy.driven_work);
  CHECK(energy.viscous_loss > 0.0);
  CHECK(energy.friction_loss > 0.0);
  CHECK(energy.curvature_gain != 0.0);
  CHECK(std::fabs(energy.curvature_gain) < 0.01 * energy.lost());
  CHECK(std::fabs(energy.balance() - before) < 1e-3 * energy.lost());
}

TEST_CASE("No contact is missed between bodies of any speed, and fast ones do not make lists often") {
  // A fifth of the bodies fly some hundred times faster than the others, a floor moves sideways. Balls
  // touch where their bounding spheres do: only the list decides what is seen.
  const Ellipsoid ball{.half_axes = {3e-3, 3e-3, 3e-3}};
  Setup setup = settling(damped_frictional_law(), {ball, ball, blocky()}, 7, 1.3e-2, 1e-5);
  setup.motions.push_back(Translation{.velocity = {0.5, 0.0, 0.0}, .end = std::numeric_limits<double>::infinity()});
  setup.bodies[0].motion = 1;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (std::size_t i = 5; i < setup.bodies.size(); ++i) {
    const double x = normal(random), y = normal(random), z = normal(random);
    setup.bodies[i].velocity = (i % 5 == 0 ? 2.0 : 0.02) * Vec3(x, y, z);
  }
  Simulation simulation(setup);
  std::size_t overlaps = 0;
  constexpr int samples = 150, between = 9;
  for (int sample = 0; sample < samples; ++sample) {
    simulation.advance(between);
    std::set<std::pair<std::int32_t, std::int32_t>> known;
    for (const Contact& contact : simulation.contacts()) known.insert({contact.body_1, contact.body_2});
    const Bodies& bodies = simulation.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (std::size_t j = std::max<std::size_t>(i + 1, 5); j < bodies.size(); ++j) {
        const auto shape = [&](std::size_t body) {
          return simulation.shapes()[static_cast<std::size_t>(bodies.shape[body])].shape;
        };
        if (i >= 5 && (bodies.position[i] - bodies.position[j]).norm() > 9e-3) continue;
        const ContactGeometry found = common_normal(shape(i), bodies.pose(i), shape(j), bodies.pose(j));
        if (!is_resolved(found.status) || found.overlap < 1e-9) continue;
        ++overlaps;
        CAPTURE(i, j, found.overlap, simulation.steps());
        REQUIRE(known.contains({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)}));
      }
  }
  CHECK(overlaps > 200);  // enough that one could be missed
  // The fastest body goes half of the least skin in 2 steps.
  CHECK(simulation.counts().rebuilds < samples * between / 8);
}

TEST_CASE("Pairs that open and close between two lists ask for next to no more memory") {
  Simulation simulation(settling(damped_frictional_law(), {box()}, 6, 9.5e-3, 1e-5));
  simulation.advance(10'000);
  const auto of_the_rest = [&] { return static_cast<double>(simulation.memory_bytes() - simulation.contact_bytes()); };
  double contact = 0.0, rest = 0.0;  // after the last list
  std::uint64_t most_contacts = 0;   // since then
  int looks = 0;
  for (int k = 0; k < 200; ++k) {
    const std::uint64_t lists = simulation.counts().rebuilds;
    simulation.advance(10);
    const bool is_new = simulation.counts().rebuilds != lists;
    most_contacts = is_new ? simulation.counts().contacts : std::max(most_contacts, simulation.counts().contacts);
    const double of_a_contact = static_cast<double>(simulation.contact_bytes()) / static_cast<double>(most_contacts);
    if (is_new) contact = of_a_contact, rest = of_the_rest();
    if (contact == 0.0) continue;
    ++looks;
    // A sixteenth is spare; between two looks there may have been some contacts more.
    CHECK(of_a_contact < 1.1 * contact);
    CHECK(of_the_rest() < 1.03 * rest);
  }
  CHECK(looks > 100);
}

TEST_CASE("Any number of threads gives the same bits") {
  Simulation one(mixed_scene(1));
  one.advance(2500);
  const State expected = one.state();
  REQUIRE(one.counts().contacts > 15);  // enough that something can differ
  REQUIRE(one.counts().rebuilds > 3);
  for (const int threads : {2, 3, 4}) {
    Simulation many(mixed_scene(threads));
    many.advance(2500);
    CHECK(same(many.state(), expected));
  }
}

TEST_CASE("A restart goes on with the same bits") {
  Simulation whole(mixed_scene(1));
  whole.advance(2371);
  REQUIRE(whole.counts().contacts > 15);  // enough that something can differ
  const State state = whole.state();
  Simulation again(mixed_scene(2), state);
  CHECK(same(again.state(), state));
  CHECK(again.steps() == 2371);
  whole.advance(1500);
  again.advance(1500);
  CHECK(same(again.state(), whole.state()));
}

TEST_CASE("A state of another setup is refused") {
  Simulation simulation(mixed_scene(1));
  Setup other = mixed_scene(1);
  other.bodies.pop_back();
  CHECK_THROWS_AS(Simulation(other, simulation.state()), InputError);
  State cut = simulation.state();
  cut.arrays.pop_back();
  CHECK_THROWS_AS(Simulation(mixed_scene(1), cut), InputError);
}
