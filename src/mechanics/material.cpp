#include "osculate/mechanics/material.hpp"

#include <cmath>
#include <string>

#include "osculate/core/error.hpp"

namespace osculate {

void validate(const ElasticMaterial& material) {
  if (!(material.youngs_modulus > 0.0) || !std::isfinite(material.youngs_modulus))
    throw InputError("", "Young's modulus " + std::to_string(material.youngs_modulus), "a positive value [Pa]");
  if (!(material.poissons_ratio > -1.0 && material.poissons_ratio <= 0.5))
    throw InputError("", "Poisson's ratio " + std::to_string(material.poissons_ratio), "a value in (-1, 0.5]");
}

double effective_modulus(const ElasticMaterial& material_1, const ElasticMaterial& material_2) {
  const auto compliance = [](const ElasticMaterial& material) {
    return (1.0 - material.poissons_ratio * material.poissons_ratio) / material.youngs_modulus;
  };
  return 1.0 / (compliance(material_1) + compliance(material_2));
}

}  // namespace osculate
