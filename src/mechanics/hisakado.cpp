#include "osculate/mechanics/hisakado.hpp"

#include <cmath>
#include <string>

#include "osculate/core/error.hpp"
#include "osculate/mechanics/greenwood_williamson.hpp"
#include "osculate/mechanics/mindlin.hpp"

namespace osculate::hisakado {

Surface surface(double asperity_radius, double height_deviation, double asperities, const ElasticMaterial& material_1,
                const ElasticMaterial& material_2, double friction) {
  const auto require = [](const char* name, double value) {
    if (!(value > 0.0) || !std::isfinite(value))
      throw InputError("hisakado::surface", std::string(name) + " " + std::to_string(value),
                       "a positive, finite value");
  };
  require("asperity radius", asperity_radius);
  require("height deviation", height_deviation);
  require("number of asperities", asperities);
  if (!(friction >= 0.0) || !std::isfinite(friction))
    throw InputError("hisakado::surface", "friction coefficient " + std::to_string(friction), "a finite value >= 0");
  return {.asperity_radius = asperity_radius,
          .height_deviation = height_deviation,
          .asperities = asperities,
          .modulus = effective_modulus(material_1, material_2),
          .compliance_ratio = 1.0 + 0.5 * mindlin::shear_coupling(material_1, material_2),
          .friction = friction};
}

double asperity_contact_radius(const Surface& surface, double interference) {
  return std::sqrt(surface.asperity_radius * std::fmax(interference, 0.0));
}

double asperity_compliance(const Surface& surface, double interference) {
  return surface.compliance_ratio / (2.0 * surface.modulus * asperity_contact_radius(surface, interference));
}

double sliding_interference(const Surface& surface, double displacement) {
  if (displacement == 0.0) return 0.0;
  return std::fabs(displacement) / (surface.friction * surface.compliance_ratio);
}

double sliding_share(const Surface& surface, double h, double displacement) {
  const double above = h + sliding_interference(surface, displacement) / surface.height_deviation;
  return 1.0 - std::erfc(above / std::sqrt(2.0)) / std::erfc(h / std::sqrt(2.0));
}

double normal_force(const Surface& surface, double h) {
  const double sigma = surface.height_deviation;
  return 4.0 / 3.0 * surface.modulus * surface.asperities * std::sqrt(surface.asperity_radius * sigma) * sigma *
         greenwood_williamson::height_integrals(h).three_halves;
}

double tangential_force(const Surface& surface, double h, double displacement) {
  if (surface.friction == 0.0) return 0.0;
  const double lower = h + sliding_interference(surface, displacement) / surface.height_deviation;
  return std::copysign(surface.friction * (normal_force(surface, h) - normal_force(surface, lower)), displacement);
}

double stiffness(const Surface& surface, double h) {
  return 2.0 * surface.modulus * surface.asperities * std::sqrt(surface.asperity_radius * surface.height_deviation) /
         surface.compliance_ratio * greenwood_williamson::height_integrals(h).half;
}

}  // namespace osculate::hisakado
