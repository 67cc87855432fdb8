// What the contact laws of a time step cost per contact: Hertz, viscous damping and Mindlin's partial slip with memory.
// The smallest of many repetitions is the cost; the others measure what else the machine was doing.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "osculate/mechanics/mindlin_contacts.hpp"

namespace {

namespace mindlin = osculate::mindlin;

const osculate::ElasticMaterial glass{.youngs_modulus = 71e9, .poissons_ratio = 0.22};

const mindlin::Pair pair_of_glass = mindlin::pair(glass, glass, 0.3, 1e-8);

/// How the bodies move on each other, step after step.
enum Path : int {
  oscillating,  ///< along one direction, to and fro, partial slip, no spin: few points remembered
  impact,       ///< overlap grows and shrinks while the tangential velocity turns
  wandering,    ///< overlap and both components at random: the memory is always full
};

/// Contacts at different phases of a path of 64 steps; the memories wander on from call to call.
struct Bed {
  static constexpr std::size_t length = 64;
  static constexpr std::size_t inputs = 14, outputs = 6;
  using Columns = std::array<std::vector<double>, inputs>;
  std::vector<Columns> step;
  std::vector<mindlin::MemoryBlock> memory;
  std::array<std::vector<double>, outputs> output;
  std::vector<mindlin::BatchStatus> status;

  void go(std::size_t k) {
    const Columns& c = step[k];
    mindlin::contacts(pair_of_glass,
                      {.R_i = c[0],
                       .R_j = c[1],
                       .overlap = c[2],
                       .overlap_rate = c[3],
                       .normal = {c[4], c[5], c[6]},
                       .major_axis = {c[7], c[8], c[9]},
                       .displacement = {c[10], c[11], c[12]},
                       .spin = c[13]},
                      memory,
                      {.force = {output[0], output[1], output[2]},
                       .normal_force = output[3],
                       .a_c = output[4],
                       .axis_ratio = output[5],
                       .status = status});
  }

  Bed(std::size_t size, Path path) : step(length), memory(size / mindlin::MemoryBlock::width), status(size) {
    for (auto& column : output) column.resize(size);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double friction_length = 0.3 * 1e-6;
    for (std::size_t i = 0; i < size; ++i) {
      const double R_j = 1e-3 * (0.1 + uniform(random)), R_i = R_j * std::pow(10.0, 2.0 * uniform(random));
      const double turn = 6.3 * uniform(random), phase = 6.3 * uniform(random), way = 6.3 * uniform(random);
      const auto place = [&](double s) { return friction_length * std::sin(s + phase); };
      for (std::size_t k = 0; k < length; ++k) {
        const double s = 6.283185307179586 * static_cast<double>(k) / length, before = s - 6.283185307179586 / length;
        double overlap = 1e-6;
        double x = place(s) - place(before), y = 0.0;
        if (path == impact) {
          overlap = 1e-6 * (0.02 + std::fabs(std::sin(0.5 * s + phase)));
          x = 0.01 * friction_length, y = 0.005 * friction_length * std::cos(s);
        } else if (path == wandering) {
          overlap = 1e-6 * (0.9 + 0.2 * uniform(random));
          x = 0.2 * friction_length * (uniform(random) - 0.5), y = 0.2 * friction_length * (uniform(random) - 0.5);
        }
        const std::array<double, inputs> row{R_i,
                                             R_j,
                                             overlap,
                                             1e-3,
                                             0.0,
                                             0.0,
                                             1.0,
                                             std::cos(turn),
                                             std::sin(turn),
                                             0.0,
                                             x * std::cos(way) - y * std::sin(way),
                                             x * std::sin(way) + y * std::cos(way),
                                             0.0,
                                             path == oscillating ? 0.0 : 1e-4};
        for (std::size_t column = 0; column < inputs; ++column) step[k][column].push_back(row[column]);
      }
    }
  }
};

void mindlin_contacts(benchmark::State& state, Path path) {
  Bed bed(static_cast<std::size_t>(state.range(0)), path);
  std::size_t k = 0;
  for ([[maybe_unused]] auto _ : state) {
    bed.go(k);
    k = (k + 1) % Bed::length;
    benchmark::ClobberMemory();
  }
  double points = 0.0;
  for (const auto& block : bed.memory)
    for (const double count : block.count) points += count;
  state.counters["points"] = points / static_cast<double>(bed.status.size());
  state.counters["per_contact"] =
      benchmark::Counter(static_cast<double>(bed.status.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

double smallest(const std::vector<double>& times) {
  return *std::min_element(times.begin(), times.end());
}

}  // namespace

int main(int argc, char** argv) {
  for (const auto& [name, path] : {std::pair{"oscillating", oscillating}, {"impact", impact}, {"wandering", wandering}})
    benchmark::RegisterBenchmark((std::string("hertz_viscous_mindlin/") + name).c_str(), mindlin_contacts, path)
        ->Arg(256)
        ->Arg(4096)
        ->MinTime(0.05)
        ->Repetitions(15)
        ->ComputeStatistics("min", smallest)
        ->ReportAggregatesOnly();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
