#include "osculate/dynamics/measures.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "dynamics/scenes.hpp"
#include "osculate/core/error.hpp"

using namespace osculate;

namespace {

/// Spheres on a cubic lattice in a periodic box, each pressed a little into its six neighbours.
Setup cubic_crystal(double overlap) {
  Setup setup = one_material(elastic_law(), 1e-7);
  constexpr double radius = 2e-3;
  setup.shapes = {Sphere{radius}};
  const double spacing = 2.0 * radius - overlap;
  constexpr int per_edge = 4;
  setup.box.length = Vec3::Constant(per_edge * spacing);
  for (int k = 0; k < per_edge; ++k)
    for (int j = 0; j < per_edge; ++j)
      for (int i = 0; i < per_edge; ++i) setup.bodies.push_back(at(0, spacing * Vec3(i, j, k)));
  return setup;
}

}  // namespace

TEST_CASE("A cubic crystal has six contacts a sphere, its packing fraction and the pressure of its springs") {
  constexpr double overlap = 4e-6, radius = 2e-3;
  const Simulation simulation(cubic_crystal(overlap));
  const Connectivity connected = connectivity(simulation);
  CHECK(connected.particles == 64);
  CHECK(connected.contacts == 192);
  CHECK(connected.coordination == Approx(6.0));
  CHECK(connected.particle_coordination == Approx(6.0));
  CHECK(connected.rattlers == 0);

  const double spacing = 2.0 * radius - overlap, length = 4 * spacing;
  const BoxRegion all{.lower = Vec3::Zero(), .upper = Vec3::Constant(length)};
  CHECK(solid_fraction(simulation, all, 200) ==
        Approx(4.0 / 3.0 * std::numbers::pi * std::pow(radius / spacing, 3)).epsilon(2e-3));

  const double modulus = 0.5 * 1e8 / (1.0 - 0.25 * 0.25);
  const double force = 4.0 / 3.0 * modulus * std::sqrt(0.5 * radius) * std::pow(overlap, 1.5);
  const Stress found = stress(simulation, std::pow(length, 3));
  CHECK((found.contact + force / (spacing * spacing) * Mat3::Identity()).norm() < 1e-9 * found.contact.norm());
  CHECK(found.pressure() == Approx(force / (spacing * spacing)));
  CHECK(found.streaming.norm() == 0.0);
  CHECK((fabric(simulation) - Mat3::Identity() / 3.0).norm() < 1e-12);
}

TEST_CASE("What is at rest in a box presses on its floor with its weight") {
  Simulation simulation(settling({{"hertz", {}}, {"tsuji", {{"restitution", 0.3}}}}, {Sphere{2e-3}}, 3, 5e-3, 2e-5));
  simulation.advance(40000);
  const Bodies& bodies = simulation.bodies();
  double weight = 0.0;
  for (std::size_t i = 5; i < bodies.size(); ++i) weight += 9.81 * bodies.mass[i];
  CHECK(-bodies.force[0].z() == Approx(weight).epsilon(1e-3));
  CHECK(connectivity(simulation).rattlers == 0);
  // Without friction the vertical stress times area, height by height, is the weight above: its mean over the volume
  // that holds all is weight times the mean height of the bodies' support, hence the virial of the weights.
  double virial = 0.0;
  for (std::size_t i = 5; i < bodies.size(); ++i) virial += 9.81 * bodies.mass[i] * bodies.position[i].z();
  const double volume = 1e-6;
  CHECK(-stress(simulation, volume).contact(2, 2) * volume == Approx(virial).epsilon(1e-3));
}
