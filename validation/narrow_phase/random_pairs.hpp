#pragma once
// Reproducible random pairs of superquadrics. A pair is a function of (family, seed, index) alone, so that a finding is
// reported by three words and a failing pair is made again without its predecessors. The random bits are the same on
// every machine (SplitMix64); the last digits of the coordinates follow the machine's exp, log and pow.

#include <cstdint>
#include <string>
#include <vector>

#include "osculate/core/types.hpp"
#include "osculate/shapes/superquadric.hpp"

namespace osculate::validation {

struct Pair {
  Superquadric shape_1;
  Pose pose_1;
  Superquadric shape_2;
  Pose pose_2;
  std::string label;
};

/// SplitMix64 (Steele, Lea & Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t state) : state_(state) {}
  std::uint64_t bits();
  double uniform();  ///< in [0, 1), 53 bits
  double uniform(double low, double high);
  double log_uniform(double low, double high);  ///< 0 < low ≤ high
  bool coin() { return (bits() >> 63U) != 0; }
  Vec3 direction();    ///< uniform on the sphere
  Quat orientation();  ///< uniform over rotations

 private:
  std::uint64_t state_;
};

/// What a family of pairs draws from.
struct PairFamily {
  enum class Draw {
    real,         ///< log-uniform in n − 1, n1 and n2 independent
    even_integer  ///< even integers, uniform
  };
  std::string name;
  Draw draw = Draw::real;
  double least_exponent = 1.05;
  double largest_exponent = 32.0;
  double largest_aspect = 100.0;       ///< longest half-axis over shortest, log-uniform from 1
  double largest_size_ratio = 1000.0;  ///< R_vol over R_vol, log-uniform from 1, either body the larger
  double least_overlap = 1e-8;         ///< over R_vol of the smaller body, log-uniform
  double largest_overlap = 0.3;
};

/// "ellipsoid", "even", "n >= 2", "n < 2", "any": the whole range each, so that trouble shows where it belongs.
std::vector<PairFamily> pair_families();

struct RandomPair {
  Pair pair;
  double overlap;  ///< [m] g along `normal`: an upper bound of the depth; it is the depth where no other direction is
                   ///< shallower, which is the rule for small overlaps
  Vec3 normal;     ///< unit, from body 1 to body 2; a stationary direction of g
};

/// Pair number `index` of a family. Half of the time a body's contact normal is drawn from the sphere (favours edges
/// and vertices), half of the time as the normal at a random surface point (favours faces), each body by itself. Sizes
/// from micrometres to metres, positions within ten body sizes of the origin.
RandomPair random_pair(const PairFamily& family, std::uint64_t seed, std::uint64_t index);

/// The same pair moved until the global minimum of g, by `reference_depth`, is `overlap` within 1e-9 relative (or the
/// round-off of the positions). Milliseconds a pair.
RandomPair with_exact_depth(RandomPair random_pair);

}  // namespace osculate::validation
