#include "lammps/engine_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "io/progress.hpp"
#include "io/table.hpp"
#include "lammps/bulk.hpp"
#include "lammps/engine_bench.hpp"
#include "lammps/rank_group.hpp"
#include "lammps/trajectories.hpp"

namespace osculate::lammps {
namespace {

/// Of single contacts, until a body meets a second one.
constexpr double trajectory_bar = 1e-10;
/// Welch's t of eight degrees of freedom exceeds it once in a thousand times by chance.
constexpr double bulk_bar = 5.04;

std::vector<int> numbers_of_ranks() {
  std::vector<int> ranks;
  for (int n = 1; n <= size_of(MPI_COMM_WORLD); n *= 2) ranks.push_back(n);
  return ranks;
}

std::string ranks_text(int ranks) {
  return fmt::format("{} rank{}", ranks, ranks == 1 ? "" : "s");
}

bool validate_trajectories(const io::Scene& scene, const std::vector<int>& ranks) {
  constexpr std::uint64_t every = 10, rows = 20;
  const bool is_first = rank_in(MPI_COMM_WORLD) == 0;
  io::Table table{{"time", "met", "single", "nudged, single"}, {}, 0};
  for (const int n : ranks) table.header.push_back(ranks_text(n) + ", single");
  table.header.push_back("nudged, all");
  for (const int n : ranks) table.header.push_back(ranks_text(n) + ", all");
  double worst = 0.0;
  std::size_t most_single = 0;
  double next_decade = 0.0;
  const auto add = [&](const TrajectoryRow& row) {
    table.rows.push_back({fmt::format("{:.3f} ms", 1e3 * row.time), fmt::format("{}", row.met),
                          fmt::format("{}", row.single), fmt::format("{:.1e}", row.nudged.single)});
    for (const Difference& one : row.lammps) table.rows.back().push_back(fmt::format("{:.1e}", one.single));
    table.rows.back().push_back(fmt::format("{:.1e}", row.nudged.all));
    for (const Difference& one : row.lammps) table.rows.back().push_back(fmt::format("{:.1e}", one.all));
  };
  io::Progress progress("trajectories, the whole time at most");
  const auto look = [&](const TrajectoryRow& row) {
    progress.update(row.time / scene.duration);
    most_single = std::max(most_single, row.single);
    double most = row.nudged.all;
    for (const Difference& one : row.lammps) {
      worst = std::max(worst, one.single);
      most = std::max(most, one.all);
    }
    // A line whenever the runs have parted ten times further.
    if (row.met == 0 || most < next_decade || table.rows.size() >= rows) return;
    next_decade = 10.0 * most;
    add(row);
  };
  follow_trajectories(scene, {.ranks = ranks, .steps = scene.steps(), .every = every}, look);
  if (!is_first) return true;
  const bool agree = worst <= trajectory_bar && most_single > 0;
  fmt::print(
      "Trajectories: largest difference from the embedded engine, a line whenever it has grown tenfold\n"
      "single: bodies that have met one other only, which has met none but them; nudged: the embedded engine itself, "
      "all\n"
      "bodies begun one unit in the last place aside\n\n{}\n"
      "Single contacts on LAMMPS: {:.1e} at worst, {:.0e} allowed, of {} bodies at once. Verdict: {}.\n\n",
      io::to_text(table), worst, trajectory_bar, most_single, agree ? "they agree" : "THEY DISAGREE");
  return agree;
}

bool validate_bulk(const io::Scene& scene, const std::vector<int>& ranks, int beginnings) {
  io::Progress progress("bulk results");
  const std::vector<Ensemble> ensembles =
      run_ensembles(scene, {.ranks = ranks, .beginnings = beginnings}, [&](double done) { progress.update(done); });
  if (rank_in(MPI_COMM_WORLD) != 0) return true;
  io::Table table{{"at the end", "embedded"}, {}};
  for (const int n : ranks) table.header.insert(table.header.end(), {ranks_text(n), "t"});
  double worst = 0.0;
  for (std::size_t q = 0; q < bulk_quantities.size(); ++q) {
    const auto text = [&](const Estimate& one) {
      return fmt::format("{:.{}f} ± {:.{}f}", one.mean, bulk_quantities[q].decimals, one.error,
                         bulk_quantities[q].decimals);
    };
    const Estimate embedded = estimate(ensembles[0], q);
    table.rows.push_back({std::string(bulk_quantities[q].name), text(embedded)});
    for (std::size_t e = 1; e < ensembles.size(); ++e) {
      const Estimate lammps = estimate(ensembles[e], q);
      const double t = difference_in_errors(embedded, lammps);
      worst = std::max(worst, std::fabs(t));
      table.rows.back().push_back(text(lammps));
      table.rows.back().push_back(fmt::format("{:+.1f}", t));
    }
  }
  const bool agree = worst <= bulk_bar;
  fmt::print(
      "Bulk, {} beginnings: mean ± standard error; t: difference from the embedded engine in standard errors of "
      "it\n\n{}\n"
      "|t| is {:.2f} at worst, {:g} allowed. Verdict: {}.\n",
      beginnings, io::to_text(table), worst, bulk_bar, agree ? "they agree" : "THEY DISAGREE");
  return agree;
}

}  // namespace

bool validate_engines(const io::Scene& scene, int beginnings) {
  const std::vector<int> ranks = numbers_of_ranks();
  if (rank_in(MPI_COMM_WORLD) == 0) {
    fmt::print("{}\n\n", scene.title);
    std::fflush(stdout);
  }
  const bool trajectories = validate_trajectories(scene, ranks);
  std::fflush(stdout);
  const bool bulk = validate_bulk(scene, ranks, beginnings);
  return trajectories && bulk;
}

void bench_engines(const io::Scene& scene, int rounds, std::uint64_t steps) {
  io::Progress progress("bench");
  const EngineBench bench = time_engines(scene, {.ranks = numbers_of_ranks(), .rounds = rounds, .steps = steps},
                                         [&](double done) { progress.update(done); });
  if (rank_in(MPI_COMM_WORLD) != 0) return;
  io::Table table{{"engine", "wall", "1 rank : it", "processor", "it : embedded", "steps a list"}, {}};
  for (const EngineTimes& one : bench.engines)
    table.rows.push_back({one.engine, fmt::format("{:.0f}", one.wall),
                          fmt::format("{:.2f}", bench.engines[1].wall / one.wall), fmt::format("{:.0f}", one.processor),
                          fmt::format("{:.2f}", one.processor / bench.engines[0].processor),
                          fmt::format("{:.0f}", one.steps_a_list)});
  fmt::print(
      "{}\nNanoseconds a particle and step, the least of {} turns of {} steps: wall time; processor time of the "
      "busiest "
      "rank\n{} particles, {:.2f} contacts a particle, walls counted\n\n{}",
      scene.title, rounds, steps, bench.particles, bench.contacts, io::to_text(table));
}

}  // namespace osculate::lammps
