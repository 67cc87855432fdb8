#include "dynamics/contact_edge.hpp"

#include <cmath>

namespace osculate {

double hurwitz_zeta_of_negative(double p, double theta) {
  // Euler and Maclaurin from the eighth term on.
  constexpr int terms = 8;
  double sum = 0.0;
  for (int k = 0; k < terms; ++k) sum += std::pow(k + theta, p);
  const double x = terms + theta;
  const double power = std::pow(x, p);
  sum += power * (0.5 - x / (p + 1.0) - p / (12.0 * x));
  const double third = p * (p - 1.0) * (p - 2.0);
  sum += power * third / (720.0 * x * x * x);
  const double fifth = third * (p - 3.0) * (p - 4.0);
  return sum - power * fifth / (30240.0 * std::pow(x, 5));
}

double elastic_power(double overlap, double stored, double stiffness) {
  return 0.5 * (std::sqrt(1.0 + 4.0 * stiffness * overlap * overlap / stored) - 1.0);
}

double edge_force(double overlap, double way, double stored, double stiffness) {
  constexpr double largest_power = 4.0;
  if (!(overlap > 0.0) || overlap >= way || !(stored > 0.0) || !(stiffness > 0.0)) return 0.0;
  const double p = elastic_power(overlap, stored, stiffness);
  if (!(p > 0.0) || p > largest_power) return 0.0;
  const double theta = overlap / way, force = stored * (p + 1.0) / overlap;
  return -force * std::pow(theta, -p) * hurwitz_zeta_of_negative(p, theta);
}

}  // namespace osculate
