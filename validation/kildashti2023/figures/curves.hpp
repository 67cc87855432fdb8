#pragma once
// Curves of functions, as the figures need them.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "io/plot.hpp"

namespace osculate::validation::kildashti2023 {

/// `count` ≥ 2 values from low to high, both included.
inline std::vector<double> evenly(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(low + (high - low) * i / (count - 1));
  return values;
}

/// The same by equal factors.
inline std::vector<double> by_factors(double low, double high, int count) {
  std::vector<double> values = evenly(0.0, 1.0, count);
  for (double& value : values) value = low * std::pow(high / low, value);
  return values;
}

template <class Function>
io::Curve curve(std::string name, const std::vector<double>& x, const Function& y, io::Mark mark = io::Mark::line) {
  io::Curve curve{.name = std::move(name), .x = x, .y = {}, .mark = mark};
  for (const double value : x) curve.y.push_back(y(value));
  return curve;
}

}  // namespace osculate::validation::kildashti2023
