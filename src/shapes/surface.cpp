#include "osculate/shapes/surface.hpp"

#include <cmath>
#include <numbers>

namespace osculate {

double volume_equivalent_radius(double volume) {
  return std::cbrt(0.75 * volume / std::numbers::pi);
}

}  // namespace osculate
