#include "osculate/mechanics/impact.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "mechanics/require.hpp"

namespace osculate {

double ImpactPair::hertz_coefficient() const {
  return 4.0 / 3.0 * modulus * std::sqrt(radius);
}

void validate(const ImpactPair& pair) {
  require_positive("impact pair", "effective mass", pair.mass, "[kg]");
  require_positive("impact pair", "effective radius", pair.radius, "[m]");
  require_positive("impact pair", "effective modulus", pair.modulus, "[Pa]");
}

ImpactPair sphere_pair(double radius_1, double mass_1, double radius_2, double mass_2, double modulus) {
  const auto harmonic = [](double a, double b) { return 1.0 / (1.0 / a + 1.0 / b); };
  for (const double value : {radius_1, radius_2, mass_1, mass_2})
    if (!(value > 0.0)) throw InputError("sphere_pair", std::to_string(value), "positive radii and masses");
  const ImpactPair pair{.mass = harmonic(mass_1, mass_2), .radius = harmonic(radius_1, radius_2), .modulus = modulus};
  validate(pair);
  return pair;
}

double effective_radius(const ContactEllipse& ellipse) {
  const double gamma = ellipse.gamma();
  return ellipse.R_c * gamma * gamma;
}

namespace hertz_impact {
namespace {

/// T v/δ_max = 2 ∫ dx/(1 − x^{5/2})^{1/2} from 0 to 1.
double duration_over_transit() {
  return 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);
}

}  // namespace

double duration_constant() {
  return duration_over_transit() * std::pow(15.0 / 16.0, 0.4);
}

Impact impact(const ImpactPair& pair, double speed) {
  validate(pair);
  require_positive("hertz_impact", "speed", speed, "[m/s]");
  const double largest = std::pow(1.25 * pair.mass * speed * speed / pair.hertz_coefficient(), 0.4);
  return {.duration = duration_over_transit() * largest / speed, .largest_overlap = largest, .restitution = 1.0};
}

}  // namespace hertz_impact
}  // namespace osculate
