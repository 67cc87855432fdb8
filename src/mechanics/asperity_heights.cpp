#include "mechanics/asperity_heights.hpp"

#include <cmath>
#include <numbers>

namespace osculate {

// With z − h = x² the integrand is even, entire and falls off as exp(−x⁴/2): the trapezoidal rule on the whole line
// converges geometrically. The factor exp(−h²/2) of h > 0 is taken out, so that small values keep their digits.
double height_integral(HeightPower power, double h) {
  constexpr int points = 64;
  const double reach = h > 0.0 ? std::sqrt(80.0 / (h + std::sqrt(h * h + 80.0))) : std::sqrt(9.0 - h);
  const double step = reach / points;
  double sum = 0.0;
  for (int i = 1; i <= points; ++i) {
    const double t = step * step * i * i;
    const double exponent = h > 0.0 ? -t * (h + 0.5 * t) : -0.5 * (h + t) * (h + t);
    sum += (power == HeightPower::one_half ? t : t * t) * std::exp(exponent);
  }
  const double outside = h > 0.0 ? std::exp(-0.5 * h * h) : 1.0;
  return 2.0 * step * sum * outside / std::sqrt(2.0 * std::numbers::pi);
}

}  // namespace osculate
