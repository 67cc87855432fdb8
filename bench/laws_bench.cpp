// What the contact laws of a time step cost per contact: Hertz, viscous damping and Mindlin's partial slip with memory.
// The smallest of many repetitions is the cost; the others measure what else the machine was doing.

#include <benchmark/benchmark.h>

#include <algorithm>
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

/// How the bodies move on each other, step after step.
enum Path : int {
  oscillating,  ///< along one direction, to and fro, partial slip
  impact,       ///< overlap grows and shrinks while the tangential speed holds
  wandering,    ///< overlap and both components at random: the memory is always full
};

/// Contacts at different phases of a path of 64 steps; the memories wander on from call to call.
struct Bed {
  static constexpr std::size_t length = 64;
  std::vector<std::vector<mindlin::ContactInput>> step;
  std::vector<mindlin::Memory> memory;
  std::vector<mindlin::ContactOutput> output;

  Bed(std::size_t size, Path path) : step(length), memory(size), output(size) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double friction_length = 0.3 * 1e-6;
    for (std::size_t i = 0; i < size; ++i) {
      mindlin::ContactInput input{};
      input.R_j = 1e-3 * (0.1 + uniform(random));
      input.R_i = input.R_j * std::pow(10.0, 2.0 * uniform(random));
      input.normal = {0.0, 0.0, 1.0};
      const double turn = 6.3 * uniform(random), phase = 6.3 * uniform(random), way = 6.3 * uniform(random);
      input.major_axis = {std::cos(turn), std::sin(turn), 0.0};
      const auto place = [&](double s) { return friction_length * std::sin(s + phase); };
      for (std::size_t k = 0; k < length; ++k) {
        const double s = 6.283185307179586 * static_cast<double>(k) / length, before = s - 6.283185307179586 / length;
        input.overlap = 1e-6;
        double x = place(s) - place(before), y = 0.0;
        if (path == impact) {
          input.overlap = 1e-6 * (0.02 + std::fabs(std::sin(0.5 * s + phase)));
          x = 0.01 * friction_length, y = 0.005 * friction_length * std::cos(s);
        } else if (path == wandering) {
          input.overlap = 1e-6 * (0.9 + 0.2 * uniform(random));
          x = 0.2 * friction_length * (uniform(random) - 0.5), y = 0.2 * friction_length * (uniform(random) - 0.5);
        }
        input.displacement = {x * std::cos(way) - y * std::sin(way), x * std::sin(way) + y * std::cos(way), 0.0};
        step[k].push_back(input);
      }
    }
  }
};

const mindlin::Pair pair_of_glass = mindlin::pair(glass, glass, 0.3, 1e-8);

void mindlin_contacts(benchmark::State& state, Path path) {
  Bed bed(static_cast<std::size_t>(state.range(0)), path);
  std::size_t k = 0;
  for ([[maybe_unused]] auto _ : state) {
    mindlin::contacts(pair_of_glass, bed.step[k], bed.memory, bed.output);
    k = (k + 1) % Bed::length;
    benchmark::ClobberMemory();
  }
  double points = 0.0;
  for (const auto& memory : bed.memory) points += static_cast<double>(memory.springs.count);
  state.counters["points"] = points / static_cast<double>(bed.memory.size());
  state.counters["per_contact"] = benchmark::Counter(
      static_cast<double>(bed.memory.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
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
