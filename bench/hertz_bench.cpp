// What an elliptical Hertz contact costs, from the two radii of relative curvature to force, ellipse, stiffness and
// energy. The smallest of many repetitions is the cost; the others measure what else the machine was doing.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "osculate/mechanics/hertz.hpp"

namespace {

namespace hertz = osculate::hertz;

struct Columns {
  std::vector<double> R_i, R_j, R_min, modulus, overlap, force, a_c, b_c, pressure, stiffness, energy;
  std::vector<hertz::Validity> validity;

  explicit Columns(std::size_t size) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (std::size_t i = 0; i < size; ++i) {
      const double minor = 1e-3 * (0.1 + uniform(random));
      R_j.push_back(minor);
      R_i.push_back(minor * std::pow(10.0, 6.0 * uniform(random)));
      R_min.push_back(minor);
      modulus.push_back(1e9);
      overlap.push_back(0.01 * minor);
    }
    for (auto* column : {&force, &a_c, &b_c, &pressure, &stiffness, &energy}) column->resize(size);
    validity.resize(size);
  }
};

void count_contacts(benchmark::State& state, std::size_t contacts) {
  state.counters["per_contact"] = benchmark::Counter(
      static_cast<double>(contacts), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void batched(benchmark::State& state) {
  Columns c(static_cast<std::size_t>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) {
    hertz::contacts({c.R_i, c.R_j, c.R_min, c.modulus, c.overlap},
                    {c.force, c.a_c, c.b_c, c.pressure, c.stiffness, c.energy, c.validity});
    benchmark::ClobberMemory();
  }
  count_contacts(state, c.R_i.size());
}

void one_by_one(benchmark::State& state) {
  Columns c(static_cast<std::size_t>(state.range(0)));
  for ([[maybe_unused]] auto _ : state)
    for (std::size_t i = 0; i < c.R_i.size(); ++i)
      benchmark::DoNotOptimize(
          hertz::contact(osculate::contact_ellipse(c.R_i[i], c.R_j[i]), c.modulus[i], c.overlap[i], c.R_min[i]));
  count_contacts(state, c.R_i.size());
}

double smallest(const std::vector<double>& times) {
  return *std::min_element(times.begin(), times.end());
}

}  // namespace

BENCHMARK(batched)->Arg(1024)->Arg(100000)->Repetitions(15)->ComputeStatistics("min", smallest)->ReportAggregatesOnly();
BENCHMARK(one_by_one)->Arg(1024)->Repetitions(5)->ComputeStatistics("min", smallest)->ReportAggregatesOnly();
BENCHMARK_MAIN();
