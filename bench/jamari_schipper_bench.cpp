// What an elastic–plastic contact costs, from the two radii of relative curvature to force, area, stiffness, energy and
// memory; contacts spread over all regimes, loading and unloading.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "osculate/mechanics/jamari_schipper.hpp"

namespace {

namespace jamari_schipper = osculate::jamari_schipper;

constexpr double modulus = 60e9;
constexpr jamari_schipper::Plasticity plasticity{
    .hardness = 1.2e9, .yield_factor = 0.577, .plastic_factor = 0.7, .area_ratio = 160.0};

struct Columns {
  std::vector<double> R_i, R_j, moduli, yield, plastic, area_ratio, overlap, largest, force, area, stiffness, energy,
      residual;
  std::vector<jamari_schipper::Regime> regime;

  explicit Columns(std::size_t size) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (std::size_t i = 0; i < size; ++i) {
      R_j.push_back(1e-3 * (0.1 + uniform(random)));
      R_i.push_back(R_j.back() * std::pow(10.0, 2.0 * uniform(random)));
      const double yield_at = jamari_schipper::limits(R_i.back(), R_j.back(), modulus, plasticity).first_yield;
      largest.push_back(yield_at * std::pow(10.0, 3.0 * uniform(random) - 0.5));
      overlap.push_back(largest.back() * (0.5 + uniform(random)));
      moduli.push_back(modulus);
      yield.push_back(plasticity.yield_pressure());
      plastic.push_back(plasticity.plastic_pressure());
      area_ratio.push_back(plasticity.area_ratio);
    }
    for (auto* column : {&force, &area, &stiffness, &energy, &residual}) column->resize(size);
    regime.resize(size);
  }
};

void count_contacts(benchmark::State& state, std::size_t contacts) {
  state.counters["per_contact"] = benchmark::Counter(
      static_cast<double>(contacts), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void batched(benchmark::State& state) {
  Columns c(static_cast<std::size_t>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) {
    jamari_schipper::contacts({c.R_i, c.R_j, c.moduli, c.yield, c.plastic, c.area_ratio, c.overlap},
                              {c.largest, c.force, c.area, c.stiffness, c.energy, c.residual, c.regime});
    benchmark::ClobberMemory();
  }
  count_contacts(state, c.R_i.size());
}

void one_by_one(benchmark::State& state) {
  Columns c(static_cast<std::size_t>(state.range(0)));
  for ([[maybe_unused]] auto _ : state)
    for (std::size_t i = 0; i < c.R_i.size(); ++i) {
      jamari_schipper::Memory memory{c.largest[i]};
      benchmark::DoNotOptimize(jamari_schipper::contact(c.R_i[i], c.R_j[i], modulus, plasticity, c.overlap[i], memory));
    }
  count_contacts(state, c.R_i.size());
}

double smallest(const std::vector<double>& times) {
  return *std::min_element(times.begin(), times.end());
}

}  // namespace

BENCHMARK(batched)->Arg(1024)->Repetitions(15)->ComputeStatistics("min", smallest)->ReportAggregatesOnly();
BENCHMARK(one_by_one)->Arg(1024)->Repetitions(5)->ComputeStatistics("min", smallest)->ReportAggregatesOnly();
BENCHMARK_MAIN();
