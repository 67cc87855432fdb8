#include "app/scenes_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "app/ccd_penetration.hpp"
#include "io/checkpoint.hpp"
#include "io/checksum.hpp"
#include "osculate/core/error.hpp"
#include "osculate/dynamics/insertion.hpp"
#include "osculate/dynamics/measures.hpp"
#include "osculate/dynamics/random.hpp"
#include "osculate/geometry/common_normal.hpp"
#include "osculate/mechanics/law_registry.hpp"

namespace osculate::app {
namespace {

constexpr int walls = 5;

Setup setup_of(const BenchScene& scene, int count, const std::string& tangential) {
  Setup setup;
  setup.materials = {
      {.name = "grain", .elastic = {.youngs_modulus = scene.youngs_modulus, .poissons_ratio = 0.3}, .density = 2500.0}};
  const ElasticMaterial& elastic = setup.materials[0].elastic;
  const LawChoice law{{"hertz", {}}, {"tsuji", {{"restitution", 0.5}}}, {tangential, {{"friction", 0.5}}}};
  setup.interactions.push_back({0, 0, make_contact_law(law, elastic, elastic)});
  setup.shapes = {HalfSpace{}, scene.particle};
  setup.motions = {Fixed{}};
  setup.gravity = {0.0, 0.0, -9.81};
  setup.time_step = scene.time_step;
  const double spacing = 2.0 * bounding_radius(scene.particle) * 1.02;
  const double per_edge = std::ceil(std::cbrt(count) - 1e-9), width = per_edge * spacing;
  const auto plane = [&](const Vec3& point, const Vec3& normal) {
    setup.bodies.push_back({.shape = 0,
                            .material = 0,
                            .motion = 0,
                            .pose = {.position = point, .orientation = Quat::FromTwoVectors(Vec3::UnitZ(), normal)}});
  };
  plane(Vec3::Zero(), Vec3::UnitZ());
  plane(Vec3::Zero(), Vec3::UnitX());
  plane(Vec3::Zero(), Vec3::UnitY());
  plane({width, 0, 0}, -Vec3::UnitX());
  plane({0, width, 0}, -Vec3::UnitY());
  Random random(1);
  const BoxRegion room{.lower = Vec3::Zero(), .upper = Vec3::Constant(width)};
  for (const Vec3& point : lattice(room, spacing)) {
    if (setup.bodies.size() == static_cast<std::size_t>(count + walls)) break;
    setup.bodies.push_back({.shape = 1,
                            .material = 0,
                            .pose = {.position = point, .orientation = random.orientation()},
                            .velocity = 0.2 * random.direction()});
  }
  return setup;
}

/// Whether the mean kinetic energy has become a small share of what a fall by a bounding radius gives.
bool is_at_rest(const Simulation& simulation) {
  constexpr double small = 2e-5;
  const Bodies& bodies = simulation.bodies();
  const EnergyLedger energy = simulation.energy();
  const double fall = bodies.mass[walls] * 9.81 * simulation.shapes()[1].bounding_radius;
  return energy.kinetic + energy.rotational < small * fall * static_cast<double>(bodies.size() - walls);
}

/// Wall times per particle and step of the same scene on one thread and on two, in turns.
std::array<Timing, 2> wall_times(Simulation& one, Simulation& two, const SceneBenchSettings& settings,
                                 std::size_t particles) {
  std::array<std::vector<double>, 2> times;
  for (int i = 0; i < settings.repetitions; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const auto begin = std::chrono::steady_clock::now();
      (k == 0 ? one : two).advance(static_cast<std::uint64_t>(settings.steps));
      const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
      times[k].push_back(took.count() / static_cast<double>(particles) / settings.steps);
    }
  return {timing_of(times[0]), timing_of(times[1])};
}

struct Exhaustive {
  std::size_t missed = 0;
  double sphere_neighbours = 0.0;
};

/// Every two particles, cold, against the scene's own contacts.
Exhaustive search_all(const Simulation& simulation, const Superquadric& shape) {
  constexpr double negligible = 1e-6;
  const Bodies& bodies = simulation.bodies();
  const double radius = bounding_radius(shape);
  std::set<std::pair<std::int32_t, std::int32_t>> known;
  for (const Contact& contact : simulation.contacts()) known.insert({contact.body_1, contact.body_2});
  Exhaustive result;
  std::size_t near = 0;
  for (std::size_t i = walls; i < bodies.size(); ++i)
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      if ((bodies.position[j] - bodies.position[i]).squaredNorm() > 4.0 * radius * radius) continue;
      ++near;
      const ContactGeometry found = common_normal(shape, bodies.pose(i), shape, bodies.pose(j));
      const bool overlap = is_resolved(found.status) && found.overlap > negligible * radius;
      if (overlap && !known.contains({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)})) ++result.missed;
    }
  result.sphere_neighbours = 2.0 * static_cast<double>(near) / static_cast<double>(bodies.size() - walls);
  return result;
}

/// What finding the same contacts costs with libccd, without curvature, law and motion.
Timing time_ccd(const Simulation& simulation, const Superquadric& shape, std::size_t particles, int repetitions) {
  constexpr std::size_t most = 500;
  constexpr double tolerance = 1e-4;  // libccd's own, of lengths in bounding radii
  const Bodies& bodies = simulation.bodies();
  const double radius = bounding_radius(shape);
  const Superquadric unit{.half_axes = shape.half_axes / radius, .exponents = shape.exponents};
  const auto placed = [&](std::int32_t body) {
    Pose pose = bodies.pose(static_cast<std::size_t>(body));
    pose.position /= radius;
    return place(unit, pose);
  };
  std::vector<std::pair<PlacedBody, PlacedBody>> pairs;
  std::size_t between_particles = 0;
  for (const Contact& contact : simulation.contacts()) {
    if (contact.body_1 < walls) continue;
    ++between_particles;
    if (pairs.size() < most) pairs.emplace_back(placed(contact.body_1), placed(contact.body_2));
  }
  if (pairs.empty()) return {};
  double depth = 0.0;
  Timing timing = time_of(
      pairs.size(), std::max(3, repetitions / 4), [] {},
      [&] {
        for (const auto& [one, two] : pairs) depth += ccd_penetration(one, two, tolerance).value_or(0.0);
      });
  const double each = static_cast<double>(between_particles) / static_cast<double>(particles);
  return {.median = timing.median * each, .spread = timing.spread * each};
}

StageTimes shares_between(const StageTimes& before, const StageTimes& after) {
  StageTimes share{.move = after.move - before.move,
                   .broad = after.broad - before.broad,
                   .narrow = after.narrow - before.narrow,
                   .law = after.law - before.law};
  const double sum = share.move + share.broad + share.narrow + share.law;
  for (double* one : {&share.move, &share.broad, &share.narrow, &share.law}) *one /= sum;
  return share;
}

/// A scene with a number of particles, from its start to its times.
struct Case {
  BenchScene scene;
  Setup setup;
  std::unique_ptr<Simulation> simulation = {};  ///< settled, on one thread
  SceneTimes times = {};
  StageTimes before = {};
  StepCounts first = {};

  std::size_t particles() const { return setup.bodies.size() - walls; }
  std::uint64_t steps() const { return static_cast<std::uint64_t>(scene.settling_time / scene.time_step); }
  double work() const { return static_cast<double>(particles()) * static_cast<double>(steps()); }

  /// On two threads.
  Simulation settle(const std::function<void(double)>& progress) const {
    constexpr int usual_parts = 50, more_parts = 5, most_parts = 5 * usual_parts;
    Simulation settling(setup);
    for (int part = 0, parts = usual_parts; part < parts;) {
      settling.advance(steps() / usual_parts);
      progress(static_cast<double>(++part) / parts);
      if (part == parts && parts < most_parts && !is_at_rest(settling)) parts += more_parts;
    }
    return settling;
  }

  /// The same, or as it was kept.
  Simulation settled(const SceneBenchSettings& settings, const std::function<void(double)>& progress) const {
    if (settings.settled.empty()) return settle(progress);
    const std::filesystem::path folder = settings.settled / fmt::format("{}-{}", scene.name, particles());
    const std::string what = fmt::format("{}, {}, {} particles, {} Pa, steps of {} s, {}", scene.name, scene.shape,
                                         particles(), scene.youngs_modulus, scene.time_step, settings.tangential);
    const std::uint64_t mark = io::crc64(what);
    if (const auto found = io::find_checkpoint(folder)) {
      if (found->checkpoint.scene != mark)
        throw InputError(folder.string(), "holds the state of another scene", "one of " + what + ", or another folder");
      return {setup, found->checkpoint.state};
    }
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw InputError(folder.string(), "cannot be made (" + error.message() + ")", "a place for states");
    Simulation settling = settle(progress);
    io::write_checkpoint(folder, {.scene = mark, .state = settling.state()});
    return settling;
  }

  void prepare(const SceneBenchSettings& settings, const std::function<void(double)>& progress) {
    setup.threads = 2;
    Simulation on_two = settled(settings, progress);
    times.name = scene.name;
    times.shape = scene.shape;
    times.particles = particles();
    setup.threads = 1;
    simulation = std::make_unique<Simulation>(setup, on_two.state());
    const auto [one, two] = wall_times(*simulation, on_two, settings, particles());
    times.one_thread_wall = one;
    times.two_threads = two;
    before = simulation->times();
    first = simulation->counts();
  }

  /// What is left once the steps have been timed.
  void finish(const SceneBenchSettings& settings) {
    const auto count = static_cast<double>(particles());
    times.shares = shares_between(before, simulation->times());
    const StepCounts last = simulation->counts();
    times.steps_between_lists = static_cast<double>(settings.repetitions) * settings.steps /
                                std::max(1.0, static_cast<double>(last.rebuilds - first.rebuilds));
    times.coordination = connectivity(*simulation).coordination;
    times.contacts = static_cast<double>(last.contacts) / count;
    times.candidates = static_cast<double>(last.candidates) / count;
    times.bytes = static_cast<double>(simulation->memory_bytes()) / count;
    times.bytes_of_contact = static_cast<double>(simulation->contact_bytes()) / static_cast<double>(last.contacts);
    const Exhaustive all = search_all(*simulation, scene.particle);
    times.missed = all.missed;
    times.sphere_neighbours = all.sphere_neighbours;
    times.ccd = time_ccd(*simulation, scene.particle, particles(), settings.repetitions);
  }
};

}  // namespace

std::vector<BenchScene> bench_scenes() {
  return {{.name = "blocky",
           .shape = "5 x 5 x 5 mm, n = 4",
           .particle = {.half_axes = {2.5e-3, 2.5e-3, 2.5e-3}, .exponents = {4.0, 4.0}},
           .particles = 8000,
           .youngs_modulus = 1e7,
           .time_step = 2e-5,
           .settling_time = 0.4},
          {.name = "boxes",
           .shape = "4 x 4 x 8 mm, n = 6",
           .particle = {.half_axes = {2e-3, 2e-3, 4e-3}, .exponents = {6.0, 6.0}},
           .particles = 1000,
           .youngs_modulus = 1e8,
           .time_step = 5e-6,
           .settling_time = 0.3},
          {.name = "ellipsoids",
           .shape = "5 x 5 x 3 mm",
           .particle = {.half_axes = {2.5e-3, 2.5e-3, 1.5e-3}, .exponents = {2.0, 2.0}},
           .particles = 1000,
           .youngs_modulus = 1e7,
           .time_step = 2e-5,
           .settling_time = 0.3}};
}

std::vector<SceneTimes> time_scenes(const std::vector<BenchScene>& scenes, const SceneBenchSettings& settings,
                                    const std::function<void(double)>& progress) {
  std::vector<Case> cases;
  double work = 0.0, done = 0.0;  // in particles times steps of settling
  for (const BenchScene& scene : scenes)
    for (const int count : settings.particles.empty() ? std::vector<int>{scene.particles} : settings.particles) {
      cases.push_back({.scene = scene, .setup = setup_of(scene, count, settings.tangential)});
      work += cases.back().work();
    }
  constexpr double settling_share = 0.85;
  for (Case& one : cases) {
    one.prepare(settings, [&](double share) { progress(settling_share * (done + share * one.work()) / work); });
    done += one.work();
  }
  std::vector<TimedWork> works;
  for (const Case& one : cases)
    works.push_back({one.particles() * static_cast<std::size_t>(settings.steps),
                     [&] { one.simulation->advance(static_cast<std::uint64_t>(settings.steps)); }});
  const std::vector<Timing> timings = times_in_turns(works, settings.repetitions);
  std::vector<SceneTimes> all;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    cases[k].times.step = timings[k];
    cases[k].finish(settings);
    all.push_back(cases[k].times);
  }
  progress(1.0);
  return all;
}

}  // namespace osculate::app
