#include "lammps/engine_bench.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <optional>

#include "lammps/scene_on_ranks.hpp"
#include "osculate/dynamics/measures.hpp"

namespace osculate::lammps {
namespace {

/// Every rank gets the first one's.
void share(std::vector<BodyStart>& bodies) {
  constexpr std::size_t numbers = 13;  // of a body
  std::vector<double> flat;
  for (const BodyStart& body : bodies) {
    flat.insert(flat.end(), body.pose.position.begin(), body.pose.position.end());
    flat.insert(flat.end(), body.pose.orientation.coeffs().begin(), body.pose.orientation.coeffs().end());
    flat.insert(flat.end(), body.velocity.begin(), body.velocity.end());
    flat.insert(flat.end(), body.angular_velocity.begin(), body.angular_velocity.end());
  }
  MPI_Bcast(flat.data(), static_cast<int>(flat.size()), MPI_DOUBLE, 0, MPI_COMM_WORLD);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double* from = &flat[i * numbers];
    bodies[i].pose.position = Vec3(from[0], from[1], from[2]);
    bodies[i].pose.orientation = Quat(from[6], from[3], from[4], from[5]);
    bodies[i].velocity = Vec3(from[7], from[8], from[9]);
    bodies[i].angular_velocity = Vec3(from[10], from[11], from[12]);
  }
}

struct Times {
  double wall, processor;  ///< [ns]
};

Times now() {
  timespec mine{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &mine);
  constexpr double second = 1e9;
  return {.wall = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count(),
          .processor = second * static_cast<double>(mine.tv_sec) + static_cast<double>(mine.tv_nsec)};
}

/// Of work that all ranks do: what it took the one that it took longest.
template <class Work>
Times longest(const Work& work) {
  const Times begin = now();
  work();
  const Times end = now();
  const double mine[] = {end.wall - begin.wall, end.processor - begin.processor};
  double most[2];
  MPI_Allreduce(mine, most, 2, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return {.wall = most[0], .processor = most[1]};
}

}  // namespace

EngineBench time_engines(const io::Scene& scene, const EngineBenchOrders& orders,
                         const std::function<void(double)>& progress) {
  const bool is_first = rank_in(MPI_COMM_WORLD) == 0;
  const auto say = [&](double done) {
    if (is_first) progress(done);
  };
  constexpr int parts = 50;
  constexpr double settling = 0.8;  // of all the time, for the one who waits
  io::Scene settled = scene;
  EngineBench bench{};
  if (is_first) {
    Setup setup = scene.setup;
    setup.threads = size_of(MPI_COMM_WORLD);
    Simulation simulation(setup);
    for (int part = 1; part <= parts; ++part) {
      simulation.advance(scene.steps() / parts);
      say(settling * part / parts);
    }
    settled.setup.bodies = bodies_of(simulation);
    const Connectivity net = connectivity(simulation);
    bench.particles = net.particles;
    bench.contacts = net.coordination;
  }
  meet(MPI_COMM_WORLD);
  share(settled.setup.bodies);

  std::optional<Simulation> embedded;
  if (is_first) embedded.emplace(settled.setup);
  std::vector<std::unique_ptr<SceneOnRanks>> engines;
  constexpr double none = std::numeric_limits<double>::infinity();
  const auto add = [&](const std::string& name) {
    bench.engines.push_back({.engine = name, .wall = none, .processor = none, .steps_a_list = 0.0});
  };
  add("embedded, one thread");
  for (const int ranks : orders.ranks) {
    engines.push_back(std::make_unique<SceneOnRanks>(ranks, settled));
    add(fmt::format("LAMMPS, {} rank{}", ranks, ranks == 1 ? "" : "s"));
  }
  const auto turn = [&](std::size_t e) {
    if (e > 0) return engines[e - 1]->advance(orders.steps);
    if (embedded) embedded->advance(orders.steps);
    meet(MPI_COMM_WORLD);
  };
  // The first round is not timed: contacts get their friction, lists their age.
  for (std::size_t e = 0; e < bench.engines.size(); ++e) turn(e);
  const auto lists = [&](std::size_t e) -> double {
    if (e > 0) return static_cast<double>(engines[e - 1]->lists());
    return embedded ? static_cast<double>(embedded->counts().rebuilds) : 0.0;
  };
  for (std::size_t e = 0; e < bench.engines.size(); ++e) bench.engines[e].steps_a_list = -lists(e);
  const double items =
      static_cast<double>(std::max<std::size_t>(bench.particles, 1)) * static_cast<double>(orders.steps);
  for (int round = 0; round < orders.rounds; ++round) {
    for (std::size_t e = 0; e < bench.engines.size(); ++e) {
      const Times took = longest([&] { turn(e); });
      EngineTimes& one = bench.engines[e];
      one.wall = std::min(one.wall, took.wall / items);
      one.processor = std::min(one.processor, took.processor / items);
    }
    say(settling + (1.0 - settling) * (round + 1) / orders.rounds);
  }
  for (std::size_t e = 0; e < bench.engines.size(); ++e) {
    const double made = bench.engines[e].steps_a_list + lists(e);
    bench.engines[e].steps_a_list = orders.rounds * static_cast<double>(orders.steps) / std::max(made, 1.0);
  }
  return bench;
}

}  // namespace osculate::lammps
