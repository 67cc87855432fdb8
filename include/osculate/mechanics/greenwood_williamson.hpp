#pragma once
// Rough elastic contact: spherical asperities of Gaussian height on the contact area of smooth bodies.
//                                                                                              [GW66]
// Integrals over the heights first, then a rough patch at a prescribed separation, then a rough contact in a DEM step,
// where roughness and bulk share the overlap. h = d/σ is the separation of the mean planes in deviations of height.

#include "osculate/mechanics/contact_ellipse.hpp"

namespace osculate::greenwood_williamson {

/// Heights of asperities: φ(z) = exp(−z²/2)/(2π)^{1/2}, z in deviations.                              [KDY23 (29)]
double height_density(double height);

/// F_n(h) = ∫_h^∞ (z − h)^n φ(z) dz for the n the theory needs.
struct HeightIntegrals {
  double zero;          ///< the fraction of asperities that touch
  double half;          ///< slope of three_halves: dF_{3/2}/dh = −3/2 F_{1/2}
  double one;           ///< mean compression
  double three_halves;  ///< mean Hertz force
};
/// All of them for any h, also h ≤ 0 where the review's Bessel form of F_{3/2} does not reach: the trapezoidal rule
/// after z = h + t², which converges exponentially. Relative error below 1e-13; F_1 and F_0 are closed, and F_1
/// cancels to 1e-16 h². Zero where F underflows (h > 38). InputError if h is NaN or infinite. [KDY23 (35)]
HeightIntegrals height_integrals(double h);

/// F_1(h) = exp(−h²/2)/(2π)^{1/2} − h/2 erfc(h/2^{1/2}), where the review prints exp(−h²) and erf.    [KDY23 (36)]
double mean_compression(double h);

/// A rough surface, or the sum of two: equal in effect to a rough one against a smooth one.
struct Roughness {
  double density;    ///< χ > 0, asperities per area [1/m²]
  double radius;     ///< β > 0, of an asperity's summit [m]
  double deviation;  ///< σ > 0, standard deviation of the summits' heights [m]
};
/// Throws InputError unless all three are positive and finite.
void validate(const Roughness& roughness);

/// Force of one asperity compressed by w ≥ 0: 4/3 Ê β^{1/2} w^{3/2}.                                  [KDY23 (30)]
double asperity_force(const Roughness& roughness, double modulus, double compression);
/// Its contact area: π β w.                                                                           [KDY23 (31)]
double asperity_area(const Roughness& roughness, double compression);

/// How a rough patch carries load.
struct Patch {
  double touching;   ///< expected number of asperities in contact: χ A F_0
  double force;      ///< F [N]
  double real_area;  ///< area of true contact [m²]
  double stiffness;  ///< −dF/dd at constant nominal area [N/m]
};
/// Nominal pressure at separation h: 4/3 χ Ê β^{1/2} σ^{3/2} F_{3/2}(h) [Pa].                         [KDY23 (33)]
double pressure(const Roughness& roughness, double modulus, double h);
/// Fraction of the nominal area in true contact: π χ β σ F_1(h).                                      [KDY23 (34)]
double area_fraction(const Roughness& roughness, double h);
/// A patch whose separation is *prescribed*, uniform over a nominal area taken from any smooth theory: π a_c b_c of
/// Hertz or of Johnson–Greenwood. The bulk's own force does not enter.                                [KDY23 (32)]
/// @param nominal_area ≥ 0 [m²]
Patch patch_at(const Roughness& roughness, double modulus, double nominal_area, double h);

/// A rough contact whose layer of asperities and bulk carry one and the same force.
struct Contact {
  double force;         ///< F [N]
  double separation;    ///< h
  double bulk_overlap;  ///< δ_b = δ + σ h [m]: how far the bulk is pressed
  double a_c, b_c;      ///< nominal ellipse [m]: Hertz's at δ_b
  double real_area;     ///< [m²]
  double stiffness;     ///< dF/dδ [N/m]
};
/// A layer that would stand further apart than this number of deviations does not touch: one asperity in 10^9 would.
inline constexpr double largest_separation = 6.0;

/// A rough elastic contact in a DEM step: the mean planes of the undeformed bodies overlap by δ, the asperities hold
/// them σh apart, so the bulk is pressed by δ + σh; h is where the layer's pressure equals Hertz's mean pressure,
/// hence force and nominal area agree. Zero where h would exceed 6, so for δ ≤ −6σ; smooth bodies' Hertz as σ → 0 or χ
/// → ∞. Elastic, repulsive asperities cannot carry tension: with adhesion use `patch_at` on the adhesive area. Throws
/// InputError on bad roughness, Ê ≤ 0, δ not finite.
Contact contact(const ContactEllipse& ellipse, double modulus, const Roughness& roughness, double overlap);

}  // namespace osculate::greenwood_williamson
