#include "osculate/mechanics/vermeulen_johnson.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/elliptic_integrals.hpp"

namespace osculate::vermeulen_johnson {

kalker::Coefficients coefficients(const ContactEllipse& ellipse, double poissons_ratio, RollingAxis axis) {
  if (!(poissons_ratio > -1.0 && poissons_ratio <= 0.5))
    throw InputError("vermeulen_johnson::coefficients", "Poisson's ratio " + std::to_string(poissons_ratio),
                     "a value in (-1, 0.5]");
  const double ratio = ellipse.axis_ratio, m1 = ratio * ratio, nu = poissons_ratio;
  const auto [K, E, B, C, D] = complete_elliptic(m1);
  const double pi = std::numbers::pi;
  kalker::Coefficients result{};
  if (axis == RollingAxis::major) {
    result.c11 = pi / (ratio * (D - nu * (D - C)));
    result.c22 = pi / (ratio * (D - nu * C));
  } else {
    result.c11 = pi / ((1.0 - nu) * B + nu * m1 * C);
    result.c22 = pi / (B - nu * m1 * C);
  }
  return result;
}

Contact contact(const kalker::Coefficients& coefficients, double shear_modulus, double a_c, double b_c, double friction,
                double normal_force) {
  const auto require = [](const char* name, double value, bool good) {
    if (!good || !std::isfinite(value))
      throw InputError("vermeulen_johnson::contact", std::string(name) + " " + std::to_string(value),
                       "a finite value, > 0 or for friction and normal force >= 0");
  };
  require("shear modulus", shear_modulus, shear_modulus > 0.0);
  require("semi-axis", a_c, a_c > 0.0);
  require("semi-axis", b_c, b_c > 0.0);
  require("C11", coefficients.c11, coefficients.c11 > 0.0);
  require("C22", coefficients.c22, coefficients.c22 > 0.0);
  require("friction coefficient", friction, friction >= 0.0);
  require("normal force", normal_force, normal_force >= 0.0);
  return {.coefficients = coefficients,
          .shear_modulus = shear_modulus,
          .a_c = a_c,
          .b_c = b_c,
          .limit = friction * normal_force};
}

kalker::Creepage creepage(const Contact& contact, double longitudinal, double lateral) {
  const double size = std::hypot(longitudinal, lateral);
  if (size == 0.0) return {};
  const double share = std::fmin(size / contact.limit, 1.0);
  const double unit = contact.a_c * contact.b_c * contact.shear_modulus;
  const double linear = 3.0 * contact.limit * -std::expm1(std::log1p(-share) / 3.0) / (unit * size);
  return {.longitudinal = -linear * longitudinal / contact.coefficients.c11,
          .lateral = -linear * lateral / contact.coefficients.c22,
          .spin = 0.0};
}

kalker::Force force(const Contact& contact, const kalker::Creepage& creepage) {
  const kalker::Force linear =
      kalker::linear_force(contact.coefficients, contact.shear_modulus, contact.a_c, contact.b_c, creepage);
  const double size = std::hypot(linear.longitudinal, linear.lateral);
  const double tau = size / (3.0 * contact.limit);
  if (!(tau > 0.0)) return linear;
  // 1 − (1 − τ)³ over 3τ, without cancellation.
  const double reduction = tau < 1.0 ? 1.0 - tau + tau * tau / 3.0 : 1.0 / (3.0 * tau);
  return {.longitudinal = reduction * linear.longitudinal,
          .lateral = reduction * linear.lateral,
          .moment = reduction * linear.moment};
}

}  // namespace osculate::vermeulen_johnson
