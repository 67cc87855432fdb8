#pragma once
// Friction of spheres on a Hertz contact of overlap δ_n: the models of Di Renzo and Di Maio, Tsuji, Langston and Zheng.
// They give the force for a displacement, whatever the path: exact for none but the simplest paths (see mindlin for the
// path-dependent theory), cheap, and never above μ F_n. Forces act on body 1; displacements and velocities are its own
// relative to body 2.

#include "osculate/mechanics/material.hpp"
#include "osculate/mechanics/tangent_vector.hpp"

namespace osculate {

/// Ĝ: 1/Ĝ = (2−ν1)/G1 + (2−ν2)/G2 [Pa], the modulus of tangential contact: without slip dF_t/dδ_t = 8 Ĝ a.
/// A lecture note prints (1−ν²) for (2−ν), which is that of Ê.
double effective_shear_modulus(const ElasticMaterial& material_1, const ElasticMaterial& material_2);

}  // namespace osculate

namespace osculate::hertzian_tangential {

struct Model {
  double radius;         ///< R > 0 [m], effective radius: contact radius a = (R δ_n)^{1/2}
  double modulus;        ///< Ê > 0 [Pa]
  double shear_modulus;  ///< Ĝ > 0 [Pa]
  double friction;       ///< μ ≥ 0
};

/// Throws InputError unless R, Ê, Ĝ > 0 and μ ≥ 0, all finite.
void validate(const Model& model);

/// Starts at zero when two bodies meet.
struct Memory {
  TangentVector displacement;  ///< δ_t since then, less what slipped [m]
};

/// The normal state and the motion of the step.
struct Step {
  double overlap;              ///< δ_n [m]; ≤ 0 gives no force and clears the memory
  double normal_force;         ///< F_n ≥ 0 [N]
  TangentVector displacement;  ///< of body 1 during the step [m]
  TangentVector velocity;      ///< of body 1 [m/s]
};

/// δ_max = μ δ_n Ê/(4 Ĝ), where slip begins at constant Hertz load; μ δ_n (2−ν)/(2 (1−ν)) for like materials.
double slip_displacement(const Model& model, double overlap);

/// DDt: F = −16/3 Ĝ a δ_t, two thirds of the no-slip stiffness.                                                  [DD05]
TangentVector di_renzo(const Model& model, const Step& step, Memory& memory);

/// TTIt: F = −8 Ĝ a δ_t − η v. For two equal spheres of radius r the stiffness reads 2 (2r)^{1/2} G/(2−ν) δ_n^{1/2};
/// with r replaced by R = r/2 the same expression is a factor √2 too small. [TTI92]
/// @param damping  η ≥ 0 [N s/m]
TangentVector tsuji(const Model& model, double damping, const Step& step, Memory& memory);

/// LTH: F = −μ F_n [1 − (1 − s)^{3/2}] − η (6 m μ F_n (1 − s)^{1/2}/δ_max)^{1/2} v, s = min(|δ_t|/δ_max, 1); the first
/// term along δ_t.                                                                                              [LTH94]
/// @param mass  effective mass m ≥ 0 [kg];  damping η ≥ 0 [-]
TangentVector langston(const Model& model, double mass, double damping, const Step& step, Memory& memory);

/// ZZYt: LTH's spring with the dashpot q (1 − 0.4 q |v|) 3/2 μ F_n (1 − s)^{1/2} v, q = η/(2 G δ_max). Beyond
/// q |v| = 2.5 the bracket would turn negative and feed energy: it is held at zero.                           [ZZY12]
/// @param viscosity  η ≥ 0 [Pa s];  body_shear_modulus G > 0 of the bodies' material [Pa]
TangentVector zheng(const Model& model, double viscosity, double body_shear_modulus, const Step& step, Memory& memory);

}  // namespace osculate::hertzian_tangential
