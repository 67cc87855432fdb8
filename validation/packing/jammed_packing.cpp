#include "validation/packing/jammed_packing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "osculate/dynamics/measures.hpp"
#include "osculate/dynamics/size_distribution.hpp"
#include "osculate/dynamics/time_step.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace osculate::validation {
namespace {

// Lengths, density and modulus only set the units: what counts is that motion and pressure hardly deform the particles.
constexpr double volume_radius = 1e-3;  // m
constexpr double density = 1000.0;      // kg/m³
constexpr double modulus = 1e7;         // Pa
constexpr double speed = 0.1;           // m/s, at the start: density · speed² is 1e-6 of the modulus
constexpr double restitution = 0.2;
constexpr double jamming_pressure = 1e-5;  // of the modulus

constexpr double first_fraction = 0.25;
constexpr double crowded_fraction = 0.55;  // from there on slowly: no shape jams at random below
struct Pace {
  double strain;        // by which the cube's edge shrinks at once
  std::uint64_t steps;  // then
};
constexpr Pace fast{2e-4, 3}, slow{1e-4, 20};
constexpr double quiet = 0.05;  // kinetic energy over elastic
constexpr std::uint64_t most_steps = 1'000'000;

Setup loose_setup(const PackingRecipe& recipe) {
  Setup setup;
  setup.shapes = {scaled(recipe.shape, volume_radius / body_shape(recipe.shape).volume_radius)};
  const ElasticMaterial elastic{.youngs_modulus = modulus, .poissons_ratio = 0.3};
  setup.materials = {{.name = "grain", .elastic = elastic, .density = density}};
  setup.interactions = {
      {0, 0, make_contact_law({{"hertz", {}}, {"tsuji", {{"restitution", restitution}}}}, elastic, elastic)}};
  const double volume = body_shape(setup.shapes[0]).volume;
  const double edge = std::cbrt(static_cast<double>(recipe.particles) * volume / first_fraction);
  setup.box = {.origin = Vec3::Zero(), .length = Vec3::Constant(edge)};
  insert_randomly(setup, {.region = BoxRegion{.lower = Vec3::Zero(), .upper = Vec3::Constant(edge)},
                          .kinds = {{.shape = 0, .material = 0}},
                          .count = recipe.particles,
                          .seed = recipe.seed,
                          .fluctuation = speed});
  // Nothing would ever stop a drift of all.
  Vec3 drift = Vec3::Zero();
  for (const BodyStart& body : setup.bodies) drift += body.velocity / static_cast<double>(recipe.particles);
  for (BodyStart& body : setup.bodies) body.velocity -= drift;
  setup.time_step = time_step_limits(setup, speed).recommended;
  return setup;
}

/// The same particles in a smaller cube, their places with it. Without friction a contact remembers nothing.
Simulation shrunk(const Simulation& simulation, double strain) {
  Setup setup = simulation.setup();
  const Bodies& bodies = simulation.bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    BodyStart& body = setup.bodies[i];
    body.pose = {.position = (1.0 - strain) * wrapped(setup.box, bodies.position[i]),
                 .orientation = bodies.orientation[i]};
    body.velocity = bodies.velocity[i];
    body.angular_velocity = bodies.angular_velocity(i);
  }
  setup.box.length *= 1.0 - strain;
  return Simulation(setup);
}

double cell_volume(const Simulation& simulation) {
  return simulation.setup().box.length.prod();
}

double fraction(const Simulation& simulation) {
  return static_cast<double>(simulation.bodies().size()) * simulation.shapes()[0].volume / cell_volume(simulation);
}

double contact_pressure(const Simulation& simulation) {
  return -stress(simulation, cell_volume(simulation)).contact.trace() / 3.0 / modulus;
}

double restlessness(const Simulation& simulation) {
  const EnergyLedger energy = simulation.energy();
  return (energy.kinetic + energy.rotational) / energy.stored_normal;
}

struct Skeleton {
  double coordination, rattlers;
};

/// Particles with too few contacts are taken away, and those that then have too few.
Skeleton skeleton(const Simulation& simulation) {
  const std::vector<Contact> contacts = simulation.contacts();
  std::vector<char> is_held(simulation.bodies().size(), 1);
  for (;;) {
    std::vector<int> touching(is_held.size(), 0);
    for (const Contact& contact : contacts) {
      const auto one = static_cast<std::size_t>(contact.body_1), two = static_cast<std::size_t>(contact.body_2);
      if (is_held[one] == 0 || is_held[two] == 0) continue;
      ++touching[one];
      ++touching[two];
    }
    bool settled = true;
    double held = 0.0, ends = 0.0;
    for (std::size_t i = 0; i < is_held.size(); ++i) {
      if (is_held[i] == 0) continue;
      if (touching[i] < holding_contacts) {
        is_held[i] = 0;
        settled = false;
      }
      held += 1.0;
      ends += touching[i];
    }
    if (settled) return {held > 0.0 ? ends / held : 0.0, 1.0 - held / static_cast<double>(is_held.size())};
  }
}

/// A fifth is the way to the crowd, the rest the dying away of motion.
double progress(const Simulation& simulation) {
  const double filled = fraction(simulation);
  if (filled < crowded_fraction)
    return 0.2 * std::log(filled / first_fraction) / std::log(crowded_fraction / first_fraction);
  const double way = 1.0 - std::log(restlessness(simulation) / quiet) / std::log(1.0 / (quiet * quiet));
  return 0.2 + 0.8 * std::clamp(way, 0.0, 1.0);
}

}  // namespace

JammedPacking jam(const PackingRecipe& recipe, const std::function<void(double)>& done) {
  Simulation simulation(loose_setup(recipe));
  double furthest = 0.0;
  for (std::uint64_t steps = 0;;) {
    const double pressure = contact_pressure(simulation);
    if (pressure > 0.5 * jamming_pressure && restlessness(simulation) < quiet) break;
    if (steps > most_steps)
      throw std::runtime_error(fmt::format("{} particles of seed {} have not jammed", recipe.particles, recipe.seed));
    const Pace& pace = fraction(simulation) < crowded_fraction ? fast : slow;
    if (pressure < jamming_pressure) simulation = shrunk(simulation, pace.strain);
    simulation.advance(pace.steps);
    steps += pace.steps;
    furthest = std::max(furthest, progress(simulation));
    if (done) done(furthest);
  }
  const PeriodicBox& box = simulation.setup().box;
  const Skeleton held = skeleton(simulation);
  constexpr int points_per_axis = 64;
  return {.fraction = fraction(simulation),
          .fraction_by_points = solid_fraction(
              simulation, BoxRegion{.lower = box.origin, .upper = box.origin + box.length}, points_per_axis),
          .coordination = held.coordination,
          .rattlers = held.rattlers,
          .pressure = contact_pressure(simulation)};
}

}  // namespace osculate::validation
