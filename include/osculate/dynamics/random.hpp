#pragma once
// Random numbers that are the same with every compiler and standard library.

#include <cstdint>
#include <random>
#include <span>

#include "osculate/core/types.hpp"

namespace osculate {

/// Draws from std::mt19937_64, whose numbers the standard fixes, by distributions of its own: the standard's are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  double uniform();                        ///< in [0, 1), 53 bits
  double uniform(double from, double to);  ///< in [from, to)
  double normal();                         ///< mean 0, variance 1                                       [BM58]
  Vec3 direction();                        ///< unit vector, all directions alike
  Quat orientation();                      ///< all orientations alike                                   [Shoemake92]
  std::size_t pick(std::span<const double> weights);  ///< an index, with probability in proportion to its weight

 private:
  std::mt19937_64 bits_;
};

/// A seed of its own for each of many things that share one: the numbers of splitmix64.                [SLF14]
std::uint64_t numbered_seed(std::uint64_t seed, std::uint64_t number);

}  // namespace osculate
