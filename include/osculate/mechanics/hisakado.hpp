#pragma once
// Hisakado–Tsukizoe: tangential displacement of a rough contact, asperity by asperity.                      [HT74]
// A nominally flat contact of many equal spherical asperities whose heights are normally distributed; each is a Hertz
// contact with Mindlin's partial slip, all are displaced alike. The bulk is rigid here.
// h = d/σ is the separation of the mean planes over the height's deviation, of either sign.

#include "osculate/mechanics/material.hpp"

namespace osculate::hisakado {

/// The rough contact.
struct Surface {
  double asperity_radius;   ///< relative radius of the asperity tips [m]: the flat counts as ∞
  double height_deviation;  ///< σ [m]
  double asperities;        ///< density times nominal area, need not be whole
  double modulus;           ///< Ê [Pa]
  double compliance_ratio;  ///< κ of a circular contact, (2−ν)/(2(1−ν)) for equal bodies
  double friction;          ///< μ
};

/// From both bodies. Throws InputError unless every number is finite and > 0, μ ≥ 0.
Surface surface(double asperity_radius, double height_deviation, double asperities, const ElasticMaterial& material_1,
                const ElasticMaterial& material_2, double friction);

/// One asperity's contact radius at an interference w = z − d: (R w)^{1/2} of the *asperity* radius [m].     [KDY23
/// (81)]
double asperity_contact_radius(const Surface& surface, double interference);

/// One asperity's no-slip compliance [m/N]: (2−ν)/(8 G a) for each body, summed, that is κ/(2 Ê a).         [KDY23
/// (78)] A rigid flat adds nothing.
double asperity_compliance(const Surface& surface, double interference);

/// The interference below which an asperity slides altogether at a displacement δ_t: δ_t/(μκ) [m].          [KDY23
/// (80)]
double sliding_interference(const Surface& surface, double displacement);

/// Share of the touching asperities that slide.                                                            [KDY23 (82)]
double sliding_share(const Surface& surface, double h, double displacement);

/// Normal force [N]: 4/3 Ê N R^{1/2} σ^{3/2} ∫_h^∞ (z−h)^{3/2} φ dz.                                        [KDY23
/// (83)]
double normal_force(const Surface& surface, double h);

/// Tangential force Σ F_tk of virgin loading at a constant h [N], odd in the displacement:                  [KDY23
/// (79)]
///   F_t = μ {F_n(h) − F_n(h + |δ_t|/(μκσ))}
/// since each asperity's partial slip is the Hertz force less that of an asperity lower by δ_t/(μκ).
double tangential_force(const Surface& surface, double h, double displacement);

/// Tangential stiffness before any slip [N/m]: 2 Ê N (R σ)^{1/2}/κ ∫_h^∞ (z−h)^{1/2} φ dz.                  [KDY23
/// (84)] The review's Bessel form with prefactor √π/(4√(2h)) is this for h > 0; the integral holds for every h.
double stiffness(const Surface& surface, double h);

}  // namespace osculate::hisakado
