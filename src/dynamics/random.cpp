#include "osculate/dynamics/random.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace osculate {

double Random::uniform() {
  constexpr int dropped_bits = 11;
  return static_cast<double>(bits_() >> dropped_bits) * 0x1.0p-53;
}

double Random::uniform(double from, double to) {
  return from + (to - from) * uniform();
}

double Random::normal() {
  const double radius = std::sqrt(-2.0 * std::log1p(-uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

Vec3 Random::direction() {
  const double z = uniform(-1.0, 1.0), angle = uniform(0.0, 2.0 * std::numbers::pi), radius = std::sqrt(1.0 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

Quat Random::orientation() {
  const double share = uniform(), angle_1 = uniform(0.0, 2.0 * std::numbers::pi),
               angle_2 = uniform(0.0, 2.0 * std::numbers::pi);
  const double one = std::sqrt(1.0 - share), two = std::sqrt(share);
  return Quat(two * std::cos(angle_2), one * std::sin(angle_1), one * std::cos(angle_1), two * std::sin(angle_2))
      .normalized();
}

std::size_t Random::pick(std::span<const double> weights) {
  double left = uniform() * std::accumulate(weights.begin(), weights.end(), 0.0);
  std::size_t last = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    last = i;
    left -= weights[i];
    if (left < 0.0) break;
  }
  return last;
}

std::uint64_t numbered_seed(std::uint64_t seed, std::uint64_t number) {
  std::uint64_t z = seed + (number + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

}  // namespace osculate
