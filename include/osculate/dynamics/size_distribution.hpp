#pragma once
// How the sizes of particles are spread: factors by which a shape is scaled.

#include <variant>
#include <vector>

#include "osculate/shapes/shape.hpp"

namespace osculate {

struct UniformSizes {
  double least, most;  ///< 0 < least ≤ most
};
/// ln(size/median) is normal with the deviation `sigma`.
struct LogNormalSizes {
  double median;  ///< > 0
  double sigma;   ///< ≥ 0
};
/// P(size ≤ x) = 1 − exp(−(x/scale)^modulus): Rosin, Rammler, Sperling, Bennett by number.
struct WeibullSizes {
  double scale;    ///< > 0
  double modulus;  ///< > 0
};

using SizeDistribution = std::variant<UniformSizes, LogNormalSizes, WeibullSizes>;

/// `count` sizes that stand for equally many particles each: the medians of equal parts of the distribution by number,
/// in increasing order. Throws InputError for a distribution that is not valid or count < 1.
std::vector<double> size_classes(const SizeDistribution& distribution, int count);

/// A particle of the same form, larger by `factor` > 0. Throws InputError for walls.
Shape scaled(const Shape& shape, double factor);

}  // namespace osculate
