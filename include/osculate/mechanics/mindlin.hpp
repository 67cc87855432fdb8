#pragma once
// Elliptical Cattaneo–Mindlin–Deresiewicz: tangential displacement of two bodies held together by a Hertz pressure.
// Every displacement is the *total relative* one, of distant points of body 2 against body 1 [m].
// Here: compliances and the load paths that have closed forms. Any other path: mindlin_memory.hpp.

#include "osculate/mechanics/contact_ellipse.hpp"
#include "osculate/mechanics/material.hpp"

namespace osculate::mindlin {

/// A number for each axis of the contact ellipse.
struct Axes {
  double major;  ///< force and displacement along a_c
  double minor;  ///< along b_c
};

/// One body's no-slip compliance against the contact plane, displacement by force [m/N]:               [KDY23 (56)]
///   [(1−ν)K + νD]/(2πG a_c) along the major axis, [K − νD]/(2πG a_c) along the minor one.
/// Circular: (2−ν)/(8 G a_c). K and D of the ellipse's e². @param a_c > 0 [m]
Axes body_compliance(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material);

/// Φ: what the ellipse adds to the circular compliance of radius a_c, one body's compliance over (2−ν)/(8 G a_c).
///   Φ = 4[(1−ν)K + νD]/(π(2−ν)) for the major axis,                                                   [KDY23 (57)]
///   Φ = 4[K − νD]/(π(2−ν)) for the minor one.                                                         [KDY23 (58)]
Axes shape_factor(const ContactEllipse& ellipse, double poissons_ratio);

/// Both bodies' no-slip compliance [m/N]: the sum of `body_compliance`, different materials included.
/// Exact without slip for bodies of equal (1−2ν)/G; else the coupling of shear and pressure is neglected, as usual.
Axes compliance(const ContactEllipse& ellipse, double a_c, const ElasticMaterial& material_1,
                const ElasticMaterial& material_2);

/// Compliance ratio κ: tangential over normal compliance dδ/dF, in [1, 1/(1−ν)] for equal bodies, independent of load.
///   κ = 1 + c D/K for the major axis, 1 + c (1 − D/K) for the minor one, with c = Ê/2 (ν1/G1 + ν2/G2).  [KDY23 (64)]
/// Circular, equal bodies: (2−ν)/(2(1−ν)).
Axes compliance_ratio(const ContactEllipse& ellipse, const ElasticMaterial& material_1,
                      const ElasticMaterial& material_2);

/// c = Ê/2 (ν1/G1 + ν2/G2) of the compliance ratio: how much stiffer a pair is across than along. 0 for ν = 0.
double shear_coupling(const ElasticMaterial& material_1, const ElasticMaterial& material_2);

/// Displacement per force at `angle` [rad] from the major axis:                                      [KDY23 (62),(63)]
/// along the force C_major cos² + C_minor sin², and across it (at angle + 90°) (C_minor − C_major) cos sin, which turns
/// the displacement towards the major axis.
struct OffAxis {
  double along;
  double across;
};
OffAxis off_axis(const Axes& compliance, double angle);

/// What the closed forms need to know of a contact, at a normal force F_n, along one direction.
struct Contact {
  double compliance;  ///< total no-slip compliance C > 0 at F_n [m/N]
  double limit;       ///< sliding force μF_n > 0 [N]
};

/// From a contact's numbers. Throws InputError unless C > 0, μ > 0, F_n > 0 and all are finite.
Contact contact(double compliance, double friction, double normal_force);

/// Virgin loading at constant F_n:   δ = 3/2 μF_n C {1 − (1 − F_t/(μF_n))^{2/3}}                          [KDY23 (59)]
/// Odd in F_t; |F_t| above the limit is taken at it.
double displacement(const Contact& contact, double force);

/// The inverse:   F_t = μF_n {1 − (1 − 2|δ|/(3 C μF_n))^{3/2}}, the limit beyond `sliding_displacement`.   [KDY23 (60)]
double force(const Contact& contact, double displacement);

/// Tangential stiffness dF_t/dδ = (1 − F_t/(μF_n))^{1/3}/C on virgin loading [N/m]; 0 when sliding.        [KDY23 (61)]
double stiffness(const Contact& contact, double force);

/// Displacement at which the whole contact slides, 3/2 C μF_n [m].                                         [KDY23 (65)]
double sliding_displacement(const Contact& contact);

/// Axes of the ellipse of stick inside the ellipse of contact: (1 − F_t/(μF_n))^{1/3} of a_c and of b_c.      [MD53]
double stick_ratio(const Contact& contact, double force);

/// Decreasing F_t from a peak F_t* of virgin loading, −F_t* ≤ F_t ≤ F_t*, constant F_n:                    [KDY23 (66)]
///   δ = 3/2 μF_n C {2 (1 − (F_t*−F_t)/(2μF_n))^{2/3} − (1 − F_t*/(μF_n))^{2/3} − 1}
double unloading_displacement(const Contact& contact, double force, double peak);

/// Increasing again from −F_t*: minus the unloading at −F_t.                                              [KDY23 (67)]
double reloading_displacement(const Contact& contact, double force, double peak);

/// Stiffness on the unloading path [N/m]: (1 − (F_t*−F_t)/(2μF_n))^{1/3}/C; on reloading, at −F_t.         [KDY23 (68)]
double unloading_stiffness(const Contact& contact, double force, double peak);

/// Energy lost in a cycle F_t* → −F_t* → F_t* at constant F_n [J]:                                        [KDY23 (69)]
///   36/5 C (μF_n)² {1 − (1−L)^{5/3} − 5L/6 [1 + (1−L)^{2/3}]},  L = F_t*/(μF_n)
/// evaluated as 6/5 C (μF_n)² t³ (1 + 3q + q²), q = (1−L)^{1/3} = 1 − t: no digit lost at small L.
double cycle_energy(const Contact& contact, double peak);

/// The small-amplitude limit of the cycle energy, 2/9 C F_t*³/(μF_n) [J]:                                [KDY23 (76)]
/// for two equal spheres (2−ν) F_t*³/(18 G a μF_n).
double small_cycle_energy(const Contact& contact, double peak);

/// Oblique loading: F_n = F_n0 + F_t dF_n/dF_t moves along a line with F_t.                  [MD53; Deresiewicz57]
/// With Θ = μ dF_n/dF_t and Λ = F_t/(μF_n0), F_n = F_n0 (1 + ΘΛ). The compliance goes with F_n^{−1/3}.
struct Oblique {
  Contact initial;  ///< at F_t = 0, where F_n = F_n0 and nothing has slipped
  double coupling;  ///< Θ ≥ 0; for Θ ≥ 1 nothing slips and the path is reversible

  Contact at(double force) const;  ///< the contact when the tangential force is `force`
};

/// Throws InputError unless the coupling is finite and ≥ 0. (Θ < 0 is the same contact with F_t counted the other way.)
Oblique oblique(const Contact& initial, double coupling);

/// dδ/dF_t on loading, `force` > 0 below sliding [m/N]:                                                   [KDY23 (70)]
///   C(F_n) {Θ + (1−Θ)(1 − F_t/(μF_n))^{−1/3}};  C(F_n) for Θ ≥ 1
double oblique_loading_compliance(const Oblique& oblique, double force);

/// dδ/dF_t on unloading from F_t*, until the slip of unloading meets the stick of loading [m/N]:           [KDY23 (71)]
///   C(F_n) {−Θ + (1+Θ)(1 − (F_t*' − F_t)/(2μF_n))^{−1/3}},  F_t*' = F_t* − μ(F_n* − F_n)
/// F_t*' is the reversal moved with the friction limit; with F_t* itself this would not be the slope of the
/// displacement below. C(F_n) for Θ ≥ 1.
double oblique_unloading_compliance(const Oblique& oblique, double force, double peak);

/// Virgin loading, 0 ≤ F_t below sliding:   δ = 3/2 μF_n0 C_0 {(1+ΘΛ)^{2/3} − (1+ΘΛ−Λ)^{2/3}},            [KDY23 (72)]
/// for Θ > 1   3/2 μF_n0 C_0 {(1+ΘΛ)^{2/3} − 1}/Θ.
double oblique_displacement(const Oblique& oblique, double force);

/// Unloading from the virgin peak F_t*, −F_t* ≤ F_t ≤ F_t*; over 3/2 μF_n0 C_0:                            [KDY23 (73)]
///   2 n^{2/3} − (1+ΘΛ*−Λ*)^{2/3} − (1+ΘΛ)^{2/3},  n = 1 − [Λ*−Λ − Θ(Λ*+Λ)]/2    for Λ ≥ −Λ*(1−Θ)/(1+Θ),
///   −(1+ΘΛ)^{2/3} {1 − [1 + Λ/(1+ΘΛ)]^{2/3}}                                     below, where all is forgotten.
/// For Θ ≥ 1 the loading path backwards.
double oblique_unloading_displacement(const Oblique& oblique, double force, double peak);

/// Loading again from −F_t* to F_t*; over 3/2 μF_n0 C_0:                                                  [KDY23 (74)]
///   (1+ΘΛ)^{2/3} + (1−ΘΛ*−Λ*)^{2/3} − 2 n^{2/3},  n = 1 + [Θ(Λ−Λ*) − (Λ+Λ*)]/2
/// It does not come back to the virgin peak, but every later cycle comes back to its end.
double oblique_reloading_displacement(const Oblique& oblique, double force, double peak);

/// Energy lost in each later cycle between ±F_t* [J], 0 for Θ ≥ 1, the exact integral of the paths:       [KDY23 (75)]
///   3/2 C_0 (μF_n0)² {12/5 [((1+ΘΛ*)^{5/3} − (1−Λ*)^{5/3})/(1+Θ) + ((1−ΘΛ*)^{5/3} − (1−Λ*)^{5/3})/(1−Θ)]
///                     − 6/5 [(1+ΘΛ*)^{5/3} − (1−ΘΛ*)^{5/3}]/Θ − 4Λ*(1−Λ*)^{2/3}}
/// The review keeps the contact radius fixed, which holds for small Λ* only. Relative rounding grows as 1e-16/Λ*³.
double oblique_cycle_energy(const Oblique& oblique, double peak);

}  // namespace osculate::mindlin
