#pragma once
// Elastic constants of a body and of a pair.

namespace osculate {

/// Isotropic linear elastic solid.
struct ElasticMaterial {
  double youngs_modulus;  ///< E > 0 [Pa]
  double poissons_ratio;  ///< ν in (−1, 0.5]

  double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poissons_ratio)); }
};

/// Throws InputError unless E > 0 and −1 < ν ≤ 0.5.
void validate(const ElasticMaterial& material);

/// Effective (contact) modulus Ê: 1/Ê = (1−ν1²)/E1 + (1−ν2²)/E2 [Pa].            [KDY23 (2)]
double effective_modulus(const ElasticMaterial& material_1, const ElasticMaterial& material_2);

}  // namespace osculate
