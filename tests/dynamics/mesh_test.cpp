// Surfaces of triangles as boundaries.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "dynamics/scenes.hpp"
#include "osculate/core/error.hpp"
#include "osculate/dynamics/insertion.hpp"

using namespace osculate;

namespace {

/// A floor of triangles with corners at random.
SurfaceTriangles floor_mesh(int cells, double size) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> part(-0.3, 0.3);
  SurfaceTriangles mesh;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const bool inner = i > 0 && i < cells && j > 0 && j < cells;
      const double x = part(random), y = part(random);
      mesh.vertices.emplace_back(size * (i + (inner ? x : 0.0)) / cells, size * (j + (inner ? y : 0.0)) / cells, 0.0);
    }
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

/// Walls of a tube around y, closed at its ends by the caller's planes.
SurfaceTriangles tube(int sides, double radius, double length) {
  SurfaceTriangles mesh;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    for (const double y : {0.0, length})
      mesh.vertices.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
  }
  for (int i = 0; i < sides; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % sides);
    mesh.triangles.push_back({a, a + 1, b + 1});
    mesh.triangles.push_back({a, b + 1, b});
  }
  return mesh;
}

/// A drum of triangles that turns, with particles in it.
Setup drum(double time_step) {
  Setup setup = one_material(damped_frictional_law(), time_step);
  setup.gravity = {0.0, 0.0, -9.81};
  setup.shapes = {HalfSpace{}, blocky(), candy()};
  setup.motions.push_back(Rotation{.point = {0, 0, 0}, .axis = Vec3::UnitY(), .rate = 12.0});
  setup.meshes = {{.triangles = tube(14, 0.02, 0.02), .material = 0, .motion = 1, .pose = {}}};
  setup.bodies = {wall(0, {0, 0, 0}, Vec3::UnitY()), wall(0, {0, 0.02, 0}, -Vec3::UnitY())};
  insert_randomly(setup, {.region = BoxRegion{.lower = {-0.014, 0, -0.014}, .upper = {0.014, 0.02, 0.014}},
                          .kinds = {{.shape = 1, .material = 0}, {.shape = 2, .material = 0}},
                          .count = 30,
                          .seed = 2});
  return setup;
}

bool same(const State& a, const State& b) {
  return std::equal(a.arrays.begin(), a.arrays.end(), b.arrays.begin(), b.arrays.end(),
                    [](const StateArray& one, const StateArray& two) { return one.values == two.values; });
}

}  // namespace

TEST_CASE("Particles slide and roll over a floor of triangles as over a plane, friction and all") {
  Setup plane = one_material(damped_frictional_law(), 1e-5);
  plane.gravity = {0.0, 0.0, -9.81};
  plane.shapes = {HalfSpace{}, candy(), box(), Sphere{2e-3}};
  const double size = 0.06;
  std::mt19937_64 random(3);
  std::vector<BodyStart> particles;
  for (int i = 0; i < 4; ++i) {
    BodyStart body = at(1 + i % 3, {0.005, 0.012 * (i + 1), 4.2e-3}, random_orientation(random));
    body.velocity = {0.5, 0.02 * i, 0.0};
    body.angular_velocity = {10.0, 0.0, 20.0};
    particles.push_back(body);
  }
  Setup mesh = plane;
  plane.bodies = particles;
  plane.bodies.push_back(wall(0, Vec3::Zero(), Vec3::UnitZ()));
  mesh.bodies = particles;
  mesh.meshes = {{.triangles = floor_mesh(20, size), .material = 0, .motion = 0, .pose = {}}};
  Simulation on_plane(plane), on_mesh(mesh);
  const auto apart = [&] {
    double most = 0.0;
    for (std::size_t i = 0; i < particles.size(); ++i)
      most = std::max(most, (on_plane.bodies().position[i] - on_mesh.bodies().position[i]).norm());
    return most;
  };
  double sprung = 0.0;
  std::uint64_t contacts = 0;
  for (int i = 0; i < 500; ++i) {
    on_plane.advance(20);
    on_mesh.advance(20);
    REQUIRE(on_plane.counts().contacts == on_mesh.counts().contacts);
    contacts += on_plane.counts().contacts;
    sprung = std::max(sprung, on_plane.energy().stored_tangential);
    if (i == 100) CHECK(apart() < 1e-12);
    if (i == 200) CHECK(apart() < 1e-9);
  }
  REQUIRE(contacts > 200);
  REQUIRE(sprung > 0.0);
  // A face's flat middle leaves the point of contact, and with it the torque, to rounding: impacts on it make it grow.
  CHECK(apart() < 1e-8);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    REQUIRE(on_plane.bodies().position[i].x() > 0.02);  // over many seams
    CHECK((on_plane.bodies().velocity[i] - on_mesh.bodies().velocity[i]).norm() < 1e-6);
  }
  CHECK(on_mesh.energy().friction_loss == Approx(on_plane.energy().friction_loss).epsilon(1e-6));
}

TEST_CASE("A particle at rest on a slope of triangles stays where friction holds it") {
  Setup setup = one_material(damped_frictional_law(), 1e-5);
  setup.shapes = {Superquadric{{3e-3, 3e-3, 2e-3}, {4.0, 2.0}}};
  setup.gravity = {-9.81 * std::sin(0.2), 0.0, -9.81 * std::cos(0.2)};  // below the angle of friction
  setup.meshes = {{.triangles = floor_mesh(9, 0.03), .material = 0, .motion = 0, .pose = {}}};
  setup.bodies = {at(0, {0.015, 0.0148, 1.999e-3})};
  Simulation simulation(setup);
  simulation.advance(60000);
  CHECK(simulation.counts().contacts == 1);
  CHECK(simulation.bodies().velocity[0].norm() < 5e-3);  // it rocks
  CHECK(std::fabs(simulation.bodies().position[0].x() - 0.015) < 1e-4);
}

TEST_CASE("A drum of triangles carries its load, and its work is in the ledger") {
  Simulation simulation(drum(2.5e-6));
  const double before = simulation.energy().balance();
  simulation.advance(60000);
  const EnergyLedger energy = simulation.energy();
  CAPTURE(energy.driven_work, energy.lost(), energy.mechanical());
  CHECK(energy.driven_work > 0.0);
  CHECK(std::fabs(energy.balance() - before) < 2e-3 * energy.lost());
  for (std::size_t i = 2; i < simulation.setup().bodies.size(); ++i) {
    const Vec3& x = simulation.bodies().position[i];
    CHECK(std::hypot(x.x(), x.z()) < 0.019);
  }
}

TEST_CASE("Meshes give the same bits with any number of threads and after a restart") {
  Setup setup = drum(2e-5);
  Simulation whole(setup);
  whole.advance(4000);
  const State state = whole.state();
  REQUIRE(whole.counts().contacts > 10);
  whole.advance(2000);
  setup.threads = 3;
  Simulation again(setup, state);
  CHECK(same(again.state(), state));
  again.advance(2000);
  CHECK(same(again.state(), whole.state()));
}

TEST_CASE("Bodies are numbered: the setup's, then the faces of its meshes") {
  const Setup setup = drum(1e-5);
  const Simulation simulation(setup);
  CHECK(simulation.first_face(0) == 32);
  CHECK(simulation.bodies().size() == 32 + 28);
  CHECK(simulation.shapes().size() == 3 + 28);
}

TEST_CASE("Meshes that make no sense are refused with their number") {
  const auto refused = [](const auto& change, const std::string& why) {
    Setup setup = drum(1e-5);
    change(setup);
    CHECK_THROWS_WITH(validate(setup), Catch::Matchers::Contains("mesh 0") && Catch::Matchers::Contains(why));
  };
  refused([](Setup& setup) { setup.meshes[0].motion = 7; }, "motion 7");
  refused([](Setup& setup) { setup.meshes[0].material = 1; }, "material 1");
  refused([](Setup& setup) { setup.meshes[0].triangles.triangles.clear(); }, "no triangle");
  refused([](Setup& setup) { setup.meshes[0].pose.orientation = Quat(2, 0, 0, 0); }, "a pose that is none");
  refused([](Setup& setup) { setup.box.length = Vec3::Constant(1.0); }, "periodic");
}
