#include "osculate/mechanics/twisting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <type_traits>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/elliptic_integrals.hpp"

namespace osculate::twisting {
namespace {

static_assert(std::is_trivially_copyable_v<Memory>);

double body_compliance(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material) {
  validate(material);
  const double nu = material.poissons_ratio, m1 = ellipse.axis_ratio * ellipse.axis_ratio;
  if (!(nu < 0.5)) throw InputError("twisting", "Poisson's ratio " + std::to_string(nu), "a value in (-1, 0.5)");
  const auto [K, E, B, C, D] = complete_elliptic(m1);
  return 1.5 / (std::numbers::pi * material.shear_modulus() * a_c * a_c * a_c) * (B * D - nu * E * C) /
         (E - 4.0 * nu * m1 * C);
}

void require(const char* name, double value, bool good, const char* expected) {
  if (!good || !std::isfinite(value))
    throw InputError("twisting", std::string(name) + " " + std::to_string(value), expected);
}

}  // namespace

double compliance(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material_1,
                  const ElasticMaterial& material_2) {
  require("major semi-axis", a_c, a_c > 0.0, "a positive, finite value [m]");
  return body_compliance(ellipse, a_c, material_1) + body_compliance(ellipse, a_c, material_2);
}

double limit(const ContactEllipse& ellipse, double a_c, double friction, double normal_force) {
  require("friction coefficient", friction, friction >= 0.0, "a finite value >= 0");
  require("major semi-axis", a_c, a_c >= 0.0, "a finite value >= 0 [m]");
  require("normal force", normal_force, normal_force >= 0.0, "a finite value >= 0 [N]");
  return 0.375 * friction * normal_force * a_c * ellipse.E;
}

Contact contact(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material_1,
                const ElasticMaterial& material_2, double friction, double normal_force) {
  return {.stiffness = 1.0 / compliance(ellipse, a_c, material_1, material_2),
          .limit = limit(ellipse, a_c, friction, normal_force)};
}

double advance(Memory& memory, const Contact& contact, double twist) {
  const double kept = contact.stiffness < memory.stiffness ? contact.stiffness / memory.stiffness : 1.0;
  const double trial = kept * memory.moment + contact.stiffness * twist;
  memory = {.moment = std::clamp(trial, -contact.limit, contact.limit), .stiffness = contact.stiffness};
  return memory.moment;
}

}  // namespace osculate::twisting
